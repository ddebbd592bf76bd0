// Does what the pages for users say, line by line: indented blocks that begin with "# FILE" are written as
// that file, indented lines that begin with "campaign" or "mpirun" are run. Realizations follow a made-up
// law. Commands that stand elsewhere, in a sentence, a table or an example's first lines, are held against
// the program's own reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

struct Step {
  std::string file;  // to write; empty for a command
  std::string text;
};

bool is_command(const std::string& line) {
  return line.starts_with("campaign ") || line.starts_with("mpirun ");
}

std::vector<Step> steps_of(const std::string& page) {
  std::ifstream stream(std::string(CPT_SOURCE) + "/docs/" + page);
  EXPECT_TRUE(stream.is_open()) << page;
  std::vector<Step> steps;
  bool in_block = false;  // what follows is more of the file
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("    ")) {
      in_block = in_block && line.empty();
      continue;
    }
    std::string text = line.substr(4);
    for (std::string more; text.ends_with("\\") && std::getline(stream, more);)
      text = text.substr(0, text.size() - 1) + more.substr(more.find_first_not_of(' '));
    if (in_block) {
      steps.back().text += text + "\n";
    } else if (text.starts_with("# ") && text.find('.') != std::string::npos) {
      steps.push_back({text.substr(2), ""});
      in_block = true;
    } else if (is_command(text)) {
      steps.push_back({"", text});
    }
  }
  return steps;
}

// As a shell splits it, double quotes and all.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words(1);
  bool quoted = false;
  for (const char c : command) {
    if (c == '"')
      quoted = !quoted;
    else if (c == ' ' && !quoted)
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

// What the pages take for granted: recordings, one of the law with a compacted surface, and a study.
void write_inputs(const StudyFolder& folder) {
  std::string depths;
  for (double z = 0.03; z < 0.30; z += 0.001)
    depths += std::to_string(z) + "," +
              std::to_string(4.0 * std::sqrt(z) *
                             std::exp(0.3 * std::exp(-z / 0.05) + 0.01 * std::sin(400.0 * z))) +
              "\n";
  folder.write("first.csv", "z_m,qc\n" + depths);
  folder.write("chamber.csv", "z_m,qc_measured_MPa\n" + depths + "0.31,-9999\n");
  const std::filesystem::path source = CPT_SOURCE, corpus = source / "tests/recordings/corpus";
  folder.write("S04.gef", text_of(corpus / "plain.gef"));
  folder.write("site.ags",
               std::regex_replace(text_of(corpus / "two_pushes.ags"), std::regex("CPT1"), "CPT01"));
  folder.write("sens.toml", text_of(source / "examples/sens.toml"));
  folder.write("layered.toml",
               std::regex_replace(text_of(source / "examples/paper/layered.toml"),
                                  std::regex(R"re(preset = "paper")re"), R"re(preset = "quick")re"));
}

struct Page {
  const char* name;
  int commands;  // at least
};

class Documented : public testing::TestWithParam<Page> {};

TEST_P(Documented, CommandsDoWhatThePageSays) {
  const StudyFolder folder;
  write_inputs(folder);
  const std::string home = std::filesystem::path(folder.file("x")).parent_path();
  int commands = 0;
  for (const Step& step : steps_of(GetParam().name)) {
    if (!step.file.empty()) {
      folder.write(step.file, step.text);
      continue;
    }
    ++commands;
    std::vector<std::string> words = words_of(step.text);
    const bool mpi = words.front() == "mpirun";
    words.erase(words.begin(), words.begin() + (mpi ? 4 : 1));  // mpirun -np N campaign
    const std::string first = words.front();
    if (first.ends_with(".toml") || first == "diagnose" || first == "rerun") {
      words.emplace_back("--executor");
      words.emplace_back(FAKE_REALIZATION);
    }
    if (first == "push") {  // the solver itself: a few millimetres
      if (const auto at = std::ranges::find(words, "--fields-at"); at != words.end()) *(at + 1) = "0,0.025";
      if (const auto at = std::ranges::find(words, "--wall-between"); at != words.end())
        *(at + 1) = "0.01,0.02";
      words.insert(words.end(), {"--set", "penetrometer.final_depth_m=0.026"});
    }
    Command command = mpi ? mpirun(2, words) : campaign(words);
    command.insert(command.begin(), {"/usr/bin/env", "--chdir=" + home});
    const Result result = run(command, {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"});
    EXPECT_EQ(result.exit_code, 0) << step.text << "\n" << result.out << result.err;
  }
  EXPECT_GE(commands, GetParam().commands);
}

INSTANTIATE_TEST_SUITE_P(Pages, Documented,
                         testing::Values(Page{"tutorial.md", 9}, Page{"how-to.md", 9}, Page{"output.md", 3},
                                         Page{"recordings.md", 3}),
                         [](const auto& page) { return std::string(page.param.name).substr(0, 3); });

// What the pages name as results is there afterwards.
TEST(DocumentedFiles, ReportOfTheTutorial) {
  const StudyFolder folder;
  for (const Step& step : steps_of("tutorial.md"))
    if (!step.file.empty()) folder.write(step.file, step.text);
  const Result result = run(campaign({folder.file("loose.toml"), "--executor", FAKE_REALIZATION}),
                            {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.file("loose-report/index.html")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("loose-report/report.pdf")));
}

// The sections "### campaign ..." of the reference by their command.
std::map<std::string, std::string> reference_sections() {
  const Result result = run(campaign({"reference"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::map<std::string, std::string> sections;
  const std::regex heading(R"re(^### (.+)$)re", std::regex::multiline);
  const std::string& page = result.out;
  for (std::sregex_iterator match(page.begin(), page.end(), heading), end; match != end; ++match) {
    const auto at = static_cast<std::size_t>(match->position());
    sections[(*match)[1]] = page.substr(at, page.find("\n##", at + 1) - at);
  }
  return sections;
}

// The command lines of a text: whole spans `campaign ...`, and lines of code or comment that begin with the
// program.
std::vector<std::string> mentions_in(const std::string& text) {
  const std::regex forms[] = {
      std::regex(R"re(`((?:build/release/)?campaign [^`]+|mpirun [^`]*campaign [^`]+)`)re"),
      std::regex(R"re(^(?:    |#) +((?:build/release/)?campaign .+|mpirun .*campaign .+)$)re",
                 std::regex::multiline),
      std::regex(R"re(^    ((?:build/release/)?campaign .+|mpirun .*campaign .+)$)re",
                 std::regex::multiline)};
  std::vector<std::string> mentions;
  for (const std::regex& form : forms)
    for (std::sregex_iterator match(text.begin(), text.end(), form), end; match != end; ++match)
      mentions.push_back((*match)[1]);
  return mentions;
}

// What is wrong with a command line by the reference; "" if nothing. Words in capitals stand for something.
std::string problem_of(const std::string& mention, const std::map<std::string, std::string>& sections) {
  std::istringstream stream(mention);
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words.erase(words.begin(), std::ranges::find_if(
                                 words, [](const std::string& word) { return word.ends_with("campaign"); }));
  std::string command = "campaign";
  std::size_t next = 1;
  while (next < words.size() && sections.contains(command + " " + words[next]))
    command += " " + words[next++];
  if (command == "campaign" && next < words.size()) {
    const std::string& first = words[next];
    const bool study = first.ends_with(".toml") || first == "STUDY";
    if (!study && !first.starts_with("-") && first != "[OPTIONS]") return "there is no command " + first;
    if (study) command = "campaign run";
  }
  const std::string& section = sections.at(command);
  for (const std::string& word : words)
    if (word.starts_with("--") && word != "--help" && section.find("`" + word + "`") == std::string::npos &&
        section.find("`" + word + " ") == std::string::npos)
      return command + " has no option " + word;
  // Commands whose first or second argument is one of a list.
  const std::size_t choice = command == "campaign list" ? next : command == "campaign query" ? next + 1 : 0;
  if (choice > 0 && choice < words.size() && section.find(words[choice]) == std::string::npos)
    return command + " knows no " + words[choice];
  return "";
}

TEST(DocumentedCommands, ExistWithTheirOptionsWhereverTheyStand) {
  namespace fs = std::filesystem;
  const auto sections = reference_sections();
  ASSERT_GE(sections.size(), 16u);
  std::vector<fs::path> files = {fs::path(CPT_SOURCE) / "README.md"};
  for (const char* folder : {"docs", "examples"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(CPT_SOURCE) / folder))
      if (const std::string ending = entry.path().extension();
          ending == ".md" || ending == ".toml" || ending == ".sbatch")
        files.push_back(entry.path());
  int mentions = 0;
  for (const fs::path& file : files)
    for (const std::string& mention : mentions_in(text_of(file))) {
      if (mention.starts_with("campaign realize")) continue;  // the program's own, for nobody else
      ++mentions;
      EXPECT_EQ(problem_of(mention, sections), "") << file << ": " << mention;
    }
  EXPECT_GE(mentions, 100);
}

TEST(DocumentedCommands, WhatDoesNotExistIsFound) {
  const auto sections = reference_sections();
  EXPECT_EQ(problem_of("campaign STUDY --plan", sections), "");
  EXPECT_EQ(problem_of("mpirun -np 2 build/release/campaign diagnose REQUEST --quiet", sections), "");
  EXPECT_EQ(problem_of("campaign STUDY --plans", sections), "campaign run has no option --plans");
  EXPECT_EQ(problem_of("campaign draw STUDY", sections), "there is no command draw");
  EXPECT_EQ(problem_of("campaign list flavours", sections), "campaign list knows no flavours");
}

}  // namespace
}  // namespace cpt::tests

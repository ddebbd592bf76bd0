// Does what the tutorial and the how-to pages say, line by line: indented blocks that begin with "# FILE" are
// written as that file, indented lines that begin with "campaign" or "mpirun" are run. Realizations follow a
// made-up law.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
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
  std::ifstream stream(std::string(CPT_DOCS) + "/" + page);
  EXPECT_TRUE(stream.is_open()) << page;
  std::vector<Step> steps;
  bool in_block = false;  // what follows is more of the file
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("    ")) {
      in_block = in_block && line.empty();
      continue;
    }
    const std::string text = line.substr(4);
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

// A recording of the law with a compacted surface.
void write_recording(const StudyFolder& folder) {
  std::string text = "z_m,qc\n";
  for (double z = 0.03; z < 0.30; z += 0.001)
    text += std::to_string(z) + "," +
            std::to_string(4.0 * std::sqrt(z) *
                           std::exp(0.3 * std::exp(-z / 0.05) + 0.01 * std::sin(400.0 * z))) +
            "\n";
  folder.write("first.csv", text);
}

class Documented : public testing::TestWithParam<const char*> {};

TEST_P(Documented, CommandsDoWhatThePageSays) {
  const StudyFolder folder;
  write_recording(folder);
  const std::string home = std::filesystem::path(folder.file("x")).parent_path();
  int commands = 0;
  for (const Step& step : steps_of(GetParam())) {
    if (!step.file.empty()) {
      folder.write(step.file, step.text);
      continue;
    }
    ++commands;
    std::vector<std::string> words = words_of(step.text);
    const bool mpi = words.front() == "mpirun";
    words.erase(words.begin(), words.begin() + (mpi ? 4 : 1));  // mpirun -np N campaign
    const std::string& first = words.front();
    if (first.ends_with(".toml") || first == "diagnose" || first == "rerun") {
      words.emplace_back("--executor");
      words.emplace_back(FAKE_REALIZATION);
    }
    if (first == "push") {  // the solver itself: a few millimetres
      if (const auto at = std::ranges::find(words, "--fields-at"); at != words.end()) *(at + 1) = "0,0.025";
      words.insert(words.end(), {"--set", "penetrometer.final_depth_m=0.026"});
    }
    Command command = mpi ? mpirun(2, words) : campaign(words);
    command.insert(command.begin(), {"/usr/bin/env", "--chdir=" + home});
    const Result result = run(command, {"CPT_FAKE=*:law", "CPT_FAKE_SECONDS=0.001"});
    EXPECT_EQ(result.exit_code, 0) << step.text << "\n" << result.out << result.err;
  }
  EXPECT_GE(commands, 9);
}

INSTANTIATE_TEST_SUITE_P(Pages, Documented, testing::Values("tutorial.md", "how-to.md"),
                         [](const auto& page) { return std::string(page.param).substr(0, 3); });

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

}  // namespace
}  // namespace cpt::tests

// What the program writes about itself: docs/reference.md, the man page, the completion.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

namespace fs = std::filesystem;

const fs::path source = CPT_SOURCE;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string reference() {
  const Result result = run(campaign({"reference"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return result.out;
}

TEST(Reference, CommittedPageIsWhatTheProgramWrites) {
  EXPECT_TRUE(text_of(source / "docs/reference.md") == reference())
      << "refresh it: build/release/campaign reference > docs/reference.md";
}

// Rows "| a | b |" below a table's head, without the marks of code.
std::vector<std::string> rows_below(const std::string& page, const std::string& head) {
  std::vector<std::string> rows;
  const auto at = page.find(head);
  EXPECT_NE(at, std::string::npos) << head;
  if (at == std::string::npos) return rows;
  std::istringstream lines(page.substr(at));
  std::string line;
  std::getline(lines, line);
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("|")) {
    std::erase(line, '`');
    rows.push_back(line);
  }
  return rows;
}

TEST(Reference, HasTheExitCodesAndAUsualLineForEveryCommand) {
  const std::string page = reference();
  EXPECT_EQ(rows_below(page, "| exit code | meaning |").size(), 9u);
  std::string usual;
  for (const std::string& row : rows_below(page, "| command line | does |")) usual += row + "\n";
  const Result help = run(campaign({"--help"}));
  std::istringstream lines(help.out.substr(help.out.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && line.starts_with("  ")) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    if (name == "run") continue;  // whose name may be left out
    EXPECT_NE(usual.find("| campaign " + name + " "), std::string::npos) << name;
  }
}

TEST(Reference, KnowsEveryVariableOfTheEnvironmentThatTheSourcesRead) {
  const std::string page = reference();
  const std::regex reads(R"re((getenv|envname)\("([A-Z_]+)"\))re");
  int found = 0;
  for (const char* layer :
       {"solver", "parameters", "recordings", "results", "campaign", "diagnosis", "reports", "cli"})
    for (const auto& entry : fs::recursive_directory_iterator(source / layer)) {
      if (entry.path().extension() != ".cpp") continue;
      const std::string text = text_of(entry.path());
      for (std::sregex_iterator match(text.begin(), text.end(), reads), end; match != end; ++match) {
        ++found;
        EXPECT_NE(page.find("| `" + (*match)[2].str() + "` |"), std::string::npos)
            << (*match)[2] << " of " << entry.path();
      }
    }
  EXPECT_GE(found, 2);
}

TEST(Reference, ManPageHasEveryCommandAndNoMacroThatManDoesNotKnow) {
  const Result man = run(campaign({"reference", "--man"}));
  ASSERT_EQ(man.exit_code, 0) << man.err;
  const Result help = run(campaign({"--help"}));
  std::istringstream lines(help.out.substr(help.out.find("Subcommands:")));
  std::string line;
  std::getline(lines, line);
  int commands = 0;
  while (std::getline(lines, line) && line.starts_with("  ")) {
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    EXPECT_NE(man.out.find("\n.SS campaign " + name + "\n"), std::string::npos) << name;
    ++commands;
  }
  EXPECT_GE(commands, 16);
  for (const char* section : {"NAME", "SYNOPSIS", "EXIT STATUS", "ENVIRONMENT", "FILES"})
    EXPECT_NE(man.out.find(std::string("\n.SH ") + section + "\n"), std::string::npos) << section;
  const std::vector<std::string> known = {".TH", ".SH", ".SS", ".TP", ".PP", ".nf", ".fi", ".br"};
  std::istringstream page(man.out);
  while (std::getline(page, line))
    if (line.starts_with(".") || line.starts_with("'")) {
      EXPECT_EQ(std::ranges::count(known, line.substr(0, line.find(' '))), 1) << line;
    }
}

// What bash would offer for the last word; the words as bash splits them.
std::vector<std::string> completions(const StudyFolder& folder, const std::vector<std::string>& words) {
  std::string script = "source campaign.bash\nCOMP_WORDS=(";
  for (const std::string& word : words) script += " '" + word + "'";
  script += ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) + "\n_campaign\n" +
            "for word in \"${COMPREPLY[@]}\"; do echo \"$word\"; done\n";
  folder.write("complete.sh", script);
  const std::string home = fs::path(folder.file("x")).parent_path();
  const Result result = run({"/usr/bin/env", "--chdir=" + home, "bash", "complete.sh"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  std::istringstream lines(result.out);
  std::vector<std::string> offered;
  for (std::string line; std::getline(lines, line);) offered.push_back(line);
  return offered;
}

TEST(Completion, OffersCommandsOptionsAndValues) {
  const StudyFolder folder;
  const Result script = run(campaign({"completion", "bash"}));
  ASSERT_EQ(script.exit_code, 0) << script.err;
  folder.write("campaign.bash", script.out);
  const Result checked = run({"bash", "-n", folder.file("campaign.bash")});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;

  using Words = std::vector<std::string>;
  const std::pair<Words, Words> cases[] = {
      {{"campaign", "li"}, {"list"}},
      {{"campaign", "sm"}, {"small.toml"}},
      {{"campaign", "pru"}, {"prune"}},
      {{"campaign", "prune", "small.toml", "--ot"}, {"--other-solvers"}},
      {{"campaign", "query", "small.sqlite", "unu"}, {"unused"}},
      {{"campaign", "list", "pr"}, {"profiles", "presets"}},
      {{"campaign", "query", "small.sqlite", "sens"}, {"sensitivity"}},
      {{"campaign", "query", "--format", "csv", "small.sqlite", "tor"}, {"tornado"}},
      {{"campaign", "query", "small.sqlite", "tornado", "--format", "j"}, {"json"}},
      {{"campaign", "run", "--sl"}, {"--slots"}},
      {{"campaign", "small.toml", "--pl"}, {"--plan"}},
      {{"campaign", "run", "--file-system", "n"}, {"network"}},
      {{"campaign", "report", "small.toml", "--column", "9"}, {"90"}},
      {{"campaign", "element", "tri"}, {"triaxial"}},
      {{"campaign", "element", "triaxial", "--material", "c"}, {"clay"}},
      {{"campaign", "push", "small.toml", "--set", "sand.D_r_p"}, {"sand.D_r_percent="}},
      {{"campaign", "push", "small.toml", "--set", "sand.D_r_percent", "=", ""}, {}},
      {{"campaign", "run", "--slots", ""}, {}},         // any number
      {{"campaign", "report", "--directory", ""}, {}},  // any file: left to bash
      {{"campaign", "realiz"}, {}},                     // not for users
  };
  for (const auto& [words, offered] : cases) EXPECT_EQ(completions(folder, words), offered) << words.back();
}

}  // namespace
}  // namespace cpt::tests

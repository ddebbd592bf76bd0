// Studies that are edited between two runs: nothing finished is lost, and readers see what the file says now.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

class EditedStudy : public testing::Test {
 protected:
  StudyFolder folder;
  std::string written = folder.read("small.toml");
  int runs = 0;

  // Runs the study; returns how many realizations were started.
  long start(Result* said = nullptr, int exit_code = 0) {
    const std::string log = "log" + std::to_string(++runs);
    const Result result = run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report"}),
                              {"CPT_FAKE_LOG=" + folder.file(log)});
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    if (said != nullptr) *said = result;
    if (!std::filesystem::exists(folder.file(log))) return 0;
    const std::string lines = folder.read(log);
    return std::count(lines.begin(), lines.end(), '\n');
  }
  void replace(const std::string& part, const std::string& with) {
    std::string text = folder.read("small.toml");
    ASSERT_NE(text.find(part), std::string::npos) << part;
    folder.write("small.toml", text.replace(text.find(part), part.size(), with));
  }
  void append(const std::string& text) { folder.write("small.toml", written + text); }
  Result ask(std::vector<std::string> words) const { return run(campaign(std::move(words))); }
  std::string query(const std::string& what, const std::string& sql = "") const {
    std::vector<std::string> words{"query", folder.study(), what, "--format", "csv"};
    if (!sql.empty()) words.insert(words.begin() + 3, sql);
    const Result result = ask(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
  static void expect_has(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << "lacks '" << part << "':\n" << text;
  }
  static void expect_lacks(const std::string& text, const std::string& part) {
    EXPECT_EQ(text.find(part), std::string::npos) << "has '" << part << "':\n" << text;
  }
};

TEST_F(EditedStudy, FixedValueThereAndBackRunsNothing) {
  EXPECT_EQ(start(), 6);
  const std::string before = contents(folder.file("small.sqlite"));
  append("\n[fixed]\n\"contact.friction_ratio\" = 0.75\n");
  const Result plan = ask({folder.study(), "--plan"});
  expect_has(plan.out, "6 realizations new: not run before with these settings");
  expect_has(plan.out, "6 realizations finished before that fit no row of the study: kept but unused");
  expect_has(plan.out, "the study has changed: contact.friction_ratio: 0.75, was 0.5");
  EXPECT_EQ(contents(folder.file("small.sqlite")), before) << "a plan writes nothing";

  Result said;
  EXPECT_EQ(start(&said), 6);
  expect_has(said.err, "6 realizations finished before that fit no row of the study: kept but unused");
  EXPECT_LT(said.err.find("kept but unused"), said.err.find("[1/6]"));
  expect_has(query("unused"), "sand.H,upper,75,completed");

  folder.write("small.toml", written);
  const Result back = ask({folder.study(), "--plan"});
  expect_has(back.out, "completed, unused until now");
  expect_lacks(back.out, "new");
  EXPECT_EQ(start(&said), 0);
  expect_has(said.err, "6 realizations among these unused until now");
  EXPECT_EQ(contents(folder.file("small.sqlite")), before);
}

TEST_F(EditedStudy, OnlyPruneRemovesAndOnlyWhatItNames) {
  EXPECT_EQ(start(), 6);
  EXPECT_EQ(ask({"prune", folder.study()}).out, folder.file("small.sqlite") + ": nothing to remove\n");
  append("\n[fixed]\n\"contact.friction_ratio\" = 0.75\n");
  EXPECT_EQ(start(), 6);
  const Result named = ask({"prune", folder.study()});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  expect_has(named.out, "6 unused results; nothing is removed: --yes removes them");
  expect_has(named.out, "sand.H");
  expect_has(named.out, "contact.friction_ratio = 0.5 (now 0.75");
  EXPECT_EQ(ask({"prune", folder.study(), "--other-solvers", "--yes"}).out,
            folder.file("small.sqlite") + ": nothing to remove\n");
  EXPECT_EQ(ask({"prune", folder.study(), "--failed", "--yes"}).out,
            folder.file("small.sqlite") + ": nothing to remove\n");

  // Edited back, but not run yet: they are asked for.
  folder.write("small.toml", written);
  const Result wanted = ask({"prune", folder.study(), "--yes"});
  expect_has(wanted.out, "6 unused results stay: the study asks for their settings again");
  EXPECT_EQ(start(), 0);

  const std::uintmax_t size = std::filesystem::file_size(folder.file("small.sqlite"));
  const Result removed = ask({"prune", folder.study(), "--yes"});
  EXPECT_EQ(removed.exit_code, 0) << removed.err;
  expect_has(removed.out, "6 unused results removed");
  EXPECT_LT(std::filesystem::file_size(folder.file("small.sqlite")), size);
  EXPECT_EQ(start(), 0) << "what the study asks for is still there";
  append("\n[fixed]\n\"contact.friction_ratio\" = 0.75\n");
  EXPECT_EQ(start(), 6) << "what was removed is gone";
}

TEST_F(EditedStudy, PruneWaitsForNoCampaign) {
  EXPECT_EQ(start(), 6);
  append("\n[fixed]\n\"contact.friction_ratio\" = 0.75\n");
  Background job(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report"}),
                 {"CPT_FAKE=*:wait", "CPT_FAKE_GATE=" + folder.file("gate")});
  while (children_of(job.pid()).empty() && alive(job.pid())) {
  }
  EXPECT_EQ(ask({"prune", folder.study(), "--yes"}).exit_code, 3);
  folder.write("gate", "");
  EXPECT_EQ(job.wait().exit_code, 0);
  EXPECT_EQ(ask({"prune", folder.study(), "--yes"}).exit_code, 0);
}

TEST_F(EditedStudy, ReadersTakeTheWindowsOfTheFileAndSaySo) {
  EXPECT_EQ(start(), 6);
  const std::string stored = contents(folder.file("small.sqlite"));
  const std::string window = written.substr(
      written.find("from_m"), written.find('\n', written.find("from_m")) - written.find("from_m"));
  replace(window, "from_m = 0.05");
  const Result answer = ask({"query", folder.study(), "windows", "--format", "csv"});
  EXPECT_EQ(answer.exit_code, 0) << answer.err;
  expect_has(answer.out, ",0.05,");
  expect_has(answer.err, "small.toml has been edited since its campaign last ran (window");
  expect_lacks(answer.err, "not been run");
  // As a campaign would average them.
  const Result of_database = ask({"query", folder.file("small.sqlite"), "windows", "--format", "csv"});
  expect_lacks(of_database.out, ",0.05,");
  EXPECT_EQ(of_database.err, "");

  const Result exported = ask({"export", folder.study(), "--to", folder.file("out")});
  EXPECT_EQ(exported.exit_code, 0) << exported.err;
  expect_has(folder.read("out/window_mean.csv"), ",0.05,");
  const Result compared = ask({"compare", folder.study(), folder.file("small.sqlite")});
  expect_has(compared.out, "windows differ");
  const Result reported = ask({"report", folder.study()});
  EXPECT_EQ(reported.exit_code, 0) << reported.err;
  expect_has(folder.read("small-report/index.html"), "has been edited since its campaign last ran");
  EXPECT_EQ(contents(folder.file("small.sqlite")), stored) << "nothing is written";

  EXPECT_EQ(start(), 0);
  const Result run_again = ask({"query", folder.study(), "windows", "--format", "csv"});
  EXPECT_EQ(run_again.out, answer.out);
  EXPECT_EQ(run_again.err, "");
}

TEST_F(EditedStudy, ReadersSayWhatIsNotRunYet) {
  EXPECT_EQ(start(), 6);
  replace("upper = 75", "upper = 70");
  const Result answer = ask({"query", folder.study(), "realizations", "--format", "csv"});
  expect_has(answer.err, "sand.H, bounds: 25 to 70, was 25 to 75");
  expect_has(answer.err, "of its 6 realizations, 1 has not been run yet: campaign small.toml does it");
  expect_has(answer.err, "1 stored result it no longer asks for is left out; nothing is lost");
  expect_has(answer.out, "sand.H,upper,70,pending");
  EXPECT_EQ(ask({"rerun", folder.study(), "4", "--executor", FAKE_REALIZATION}).exit_code, 2);
  EXPECT_EQ(ask({"rerun", folder.study(), "2", "--executor", FAKE_REALIZATION}).exit_code, 0);
}

TEST_F(EditedStudy, WordsAloneAreNoEdit) {
  EXPECT_EQ(start(), 6);
  append("\n# a remark\n");
  EXPECT_EQ(ask({"query", folder.study(), "windows"}).err, "");
}

TEST_F(EditedStudy, AGrownSampleKeepsItsRuns) {
  const std::string design = "\n[design]\nkind = \"latin_hypercube\"\nruns = 8\n";
  append(design);
  EXPECT_EQ(start(), 14);
  append("\n[design]\nkind = \"latin_hypercube\"\nruns = 12\n");
  const Result plan = ask({folder.study(), "--plan"});
  expect_has(plan.out, "first_runs = 8    to keep them and add 4");
  const std::string before = contents(folder.file("small.sqlite"));
  Result said;
  EXPECT_EQ(start(&said, 2), 0) << "a fresh sample only where the study says so";
  expect_has(said.err, "first_runs = 8    to keep them and add 4");
  EXPECT_EQ(contents(folder.file("small.sqlite")), before);

  append("\n[design]\nkind = \"latin_hypercube\"\nruns = 12\nfirst_runs = 8\n");
  EXPECT_EQ(start(&said), 4);
  expect_has(said.err, "the Latin hypercube has grown from 8 to 12 runs: its centred L2 discrepancy is 0.");
  append("\n[design]\nkind = \"latin_hypercube\"\nruns = 15\nfirst_runs = 8\n");
  EXPECT_EQ(start(), 3);
  append(design);
  EXPECT_EQ(start(), 0);
  append("\n[design]\nkind = \"latin_hypercube\"\nruns = 12\nfirst_runs = 12\n");
  EXPECT_EQ(start(), 12);
}

TEST_F(EditedStudy, LargerMorrisAndSobolDesignsKeepTheirRuns) {
  append("\n[design]\nkind = \"morris\"\ntrajectories = 3\n");
  const long few = start();
  append("\n[design]\nkind = \"morris\"\ntrajectories = 5\n");
  const long more = start();
  EXPECT_GT(more, 0);
  EXPECT_LE(more, 2 * 4);
  append("\n[design]\nkind = \"sobol\"\nruns = 4\n");
  start();
  append("\n[design]\nkind = \"sobol\"\nruns = 6\n");
  const long rows = start();
  EXPECT_GT(rows, 0);
  EXPECT_LE(rows, 2 * 5);
  append("\n[design]\nkind = \"morris\"\ntrajectories = 5\nseed = 2\n");
  EXPECT_GT(start(), 0);
  append("\n[design]\nkind = \"morris\"\ntrajectories = 3\n");
  EXPECT_EQ(start(), 0);
  EXPECT_GT(few, 6);
}

}  // namespace
}  // namespace cpt::tests

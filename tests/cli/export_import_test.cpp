// Campaigns exported and imported from the command line.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in:\n" << text;
}

// A study that has been run; the realization at H = 75 crashed.
class ExportImport : public testing::Test {
 protected:
  ExportImport() {
    EXPECT_EQ(run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report"}),
                  {"CPT_FAKE=sand.H=75:segfault"})
                  .exit_code,
              1);
  }
  std::string exported(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"export", folder.study()};
    words.insert(words.end(), more.begin(), more.end());
    const Result result = run(campaign(words));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result.out;
  }
  [[nodiscard]] Result import(const std::string& source, const std::string& to,
                              const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"import", folder.file(source), "--to", folder.file(to)};
    words.insert(words.end(), more.begin(), more.end());
    return run(campaign(words));
  }
  StudyFolder folder;
};

TEST_F(ExportImport, AnExportIsNotReadBack) {
  expect_has(exported({}), "small-export/samples.csv");
  exported({"--format", "json"});
  for (const char* source : {"small-export", "small.json"}) {
    const Result result = import(source, "copy.sqlite");
    EXPECT_EQ(result.exit_code, 2);
    expect_has(result.err, "copy its database");
    EXPECT_FALSE(std::filesystem::exists(folder.file("copy.sqlite")));
  }
}

TEST_F(ExportImport, AReportSaysThatResultsAreImported) {
  exported({"--format", "dakota"});
  ASSERT_EQ(import("small.dat", "copy.sqlite", {"--study", folder.study()}).exit_code, 0);
  const Result result = run(campaign({"report", folder.file("copy.sqlite")}));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  expect_has(folder.read("copy-report/index.html"), "\"imports\":[{\"file\":\"small.dat\",\"sha256\":");
  const Result sources = run(
      campaign({"query", folder.file("copy.sqlite"), "sql", "select file from import", "--format", "csv"}));
  EXPECT_EQ(sources.out.find("/tmp"), std::string::npos);
}

TEST_F(ExportImport, NoCampaignGoesOnWithIt) {
  exported({"--format", "dakota"});
  std::filesystem::remove(folder.file("small.sqlite"));
  ASSERT_EQ(import("small.dat", "small.sqlite", {"--study", folder.study()}).exit_code, 0);
  const std::string before = contents(folder.file("small.sqlite"));
  const Result result = run(campaign({folder.study(), "--executor", FAKE_REALIZATION, "--no-report"}));
  EXPECT_EQ(result.exit_code, 6);
  expect_has(result.err, "imported from small.dat");
  EXPECT_EQ(contents(folder.file("small.sqlite")), before);
}

TEST_F(ExportImport, ATableOfAnotherProgramIsSetBesideTheCampaign) {
  exported({"--format", "dakota"});
  ASSERT_EQ(import("small.dat", "other.sqlite", {"--study", folder.study()}).exit_code, 0);
  const Result compared =
      run(campaign({"compare", folder.study(), folder.file("other.sqlite"), "--format", "csv"}));
  EXPECT_EQ(compared.exit_code, 0) << compared.err;
  int failed = 0;
  for (std::size_t at = compared.out.find('\n') + 1; at < compared.out.size();
       at = compared.out.find('\n', at) + 1) {
    const std::string line = compared.out.substr(at, compared.out.find('\n', at) - at);
    if (line.find("sand.H,upper") == line.npos) {
      expect_has(line, ",0,");  // no change, to the last bit
      continue;
    }
    expect_has(line, "a failed (crashed), b failed (crashed)");
    ++failed;
  }
  EXPECT_EQ(failed, 1);
  const Result failures = run(campaign({"query", folder.file("other.sqlite"), "failures"}));
  expect_has(failures.out, "sand.H");
  EXPECT_EQ(run(campaign({"report", folder.file("other.sqlite")})).exit_code, 0);
}

TEST_F(ExportImport, PointsOfATableAreRun) {
  folder.write("points.csv", "name,sand.H,x\nstiff,60,1\nold,75,1\nsoft,22,1\n");
  const Result made = import("points.csv", "more.toml", {"--study", folder.study(), "--ignore", "x"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  expect_has(made.out, "2 new points; 1 of the 3 rows");
  ASSERT_EQ(
      run(campaign({folder.file("more.toml"), "--executor", FAKE_REALIZATION, "--no-report"})).exit_code, 0);
  const Result rows = run(campaign({"query", folder.file("more.toml"), "realizations"}));
  expect_has(rows.out, "stiff");
  expect_has(rows.out, "sand.H = 22");
}

TEST_F(ExportImport, BadInputIsToldAndNothingIsWritten) {
  const auto refused = [&](const std::string& source, const std::string& to,
                           const std::vector<std::string>& more, const std::string& message) {
    const Result result = import(source, to, more);
    EXPECT_EQ(result.exit_code, 2) << source;
    expect_has(result.err, message);
    EXPECT_FALSE(std::filesystem::exists(folder.file("new.sqlite")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("new.toml")));
  };
  const std::vector<std::string> of_study{"--study", folder.study()};
  folder.write("bad.csv", "sand.Hh,deep.q_c_mean_kPa\n30,1\n");
  folder.write("twice.csv", "sand.H,sand.H\n30,1\n");
  folder.write("points.csv", "name,sand.H\na,30\na,31\n");
  refused("none.csv", "new.sqlite", of_study,
          "none.csv: cannot be read as a table (No such file or directory)");
  refused("bad.csv", "new.sqlite", {}, "a table needs --study STUDY");
  refused("bad.csv", "new.sqlite", of_study, "bad.csv:1:1: error: sand.Hh: is neither");
  refused("bad.csv", "new.sqlite", of_study, "did you mean sand.H?");
  refused("twice.csv", "new.sqlite", of_study, "twice.csv:1:8: error: found a second column 'sand.H'");
  refused("points.csv", "new.toml", of_study, "points.csv:3:1: error: name: \"a\" names row 1 already");
  refused("bad.csv", "new.txt", of_study, "must end in .sqlite (results) or .toml (points to run)");
  refused("bad.csv", "small.sqlite", of_study, "exists; name a new file");
  refused("bad.csv", "new.sqlite", {"--study", folder.study(), "--column", "x"}, "must be KEY=NAME");
  EXPECT_EQ(run(campaign({"export", folder.study(), "--format", "json", "--to", folder.file("small.sqlite")}))
                .exit_code,
            2);
}

}  // namespace
}  // namespace cpt::tests

// Causes of differences: what the file may say, and how they come to stand on the page.
#include "validation/paper/causes.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/validation/paper/paper_campaigns.hpp"
#include "validation/paper/finding_tables.hpp"
#include "validation/paper/findings.hpp"

namespace cpt::validation::paper {
namespace {

class CauseFile : public ::testing::Test {
 protected:
  static const PaperCampaigns& campaigns() {
    static const PaperCampaigns made;
    return made;
  }
  static std::vector<Cause> read(const std::string& toml) {
    const auto file = campaigns().folder() / "causes.toml";
    std::ofstream(file) << toml;
    return read_causes(file);
  }
  static std::string error_of(const std::string& toml) {
    try {
      (void)read(toml);
    } catch (const results::Error& error) {
      const std::string what = error.what();
      return what.substr(what.find("causes.toml"));
    }
    return "no error";
  }
};

TEST_F(CauseFile, HoldsProseAndEvidenceByRow) {
  const auto causes = read(
      "[S4]\ncause = \"image pressure\"\n"
      "evidence = [{ study = \"homogeneous_sand\", window = \"sand\", parameter = \"sand.H\" }]\n"
      "[L1]\ncause = \"depths\"\n");
  ASSERT_EQ(causes.size(), 2u);
  EXPECT_EQ(causes[0].row, "S4");
  EXPECT_EQ(causes[0].text, "image pressure");
  ASSERT_EQ(causes[0].evidence.size(), 1u);
  EXPECT_EQ(causes[0].evidence[0].parameter, "sand.H");
  EXPECT_TRUE(causes[1].evidence.empty());
}

TEST_F(CauseFile, MistakesAreNamedWithTheirPlace) {
  EXPECT_EQ(error_of("[S4]\ncause = \"a\"\n[S9]\ncause = \"b\"\n").substr(0, 32),
            "causes.toml:3:2: unknown row S9:");
  EXPECT_EQ(error_of("[S4]\nreason = \"a\"\n"), "causes.toml:2:1: unknown key reason");
  EXPECT_EQ(error_of("[S4]\nevidence = []\n"), "causes.toml:1:1: cause is missing");
  EXPECT_NE(error_of("[S4]\ncause = 4\n").find("causes.toml:2:9: a text is wanted here"), std::string::npos);
  EXPECT_NE(error_of("[S4]\ncause = \"a\"\nevidence = [{ study = \"b\" }]\n").find("window is missing"),
            std::string::npos);
  EXPECT_NE(error_of("[S4\n").find("causes.toml:1"), std::string::npos);
  EXPECT_THROW((void)read_causes(campaigns().folder() / "none.toml"), results::Error);
}

TEST_F(CauseFile, RowsAreThoseOfTheFindings) {
  std::vector<std::string_view> rows;
  for (const FindingGroup& group : all_findings({campaigns().studies(), {}}))
    for (const Finding& f : group.findings)
      if (std::find(rows.begin(), rows.end(), f.row) == rows.end()) rows.push_back(f.row);
  std::vector<std::string_view> known = paper_rows();
  std::sort(rows.begin(), rows.end());
  std::sort(known.begin(), known.end());
  EXPECT_EQ(rows, known);
}

TEST_F(CauseFile, EvidenceSpeaksFromTheDatabases) {
  const Studies studies = campaigns().studies();
  EXPECT_EQ(in_numbers({"homogeneous_sand", "sand", "sand.H"}, studies).substr(0, 57),
            "`homogeneous_sand`, window sand: H from 25 to 75 changes ");
  EXPECT_EQ(in_numbers({"elsewhere", "sand", "sand.H"}, studies), "elsewhere has not been run");
  EXPECT_EQ(in_numbers({"homogeneous_sand", "sand", "clay.G_kPa"}, studies),
            "homogeneous_sand: has no row clay.G_kPa");
}

// In the made-up campaigns S5 differs and S4 holds.
TEST_F(CauseFile, StandsWhereTheRowDiffersAndNowhereElse) {
  const std::vector<Cause> causes = {{"S4", "not to be told", {}},
                                     {"S5", "walls\nof\nclay", {{"homogeneous_sand", "sand", "sand.H"}}}};
  const std::string text = finding_tables({campaigns().studies(), {}}, causes, nullptr);
  EXPECT_EQ(text.find("not to be told"), std::string::npos);
  EXPECT_NE(
      text.find("- **S5 differs:** walls of clay\n  - `homogeneous_sand`, window sand: H from 25 to 75"),
      std::string::npos);
  EXPECT_NE(text.find("- **M1 differs:** the cause is not known yet.\n"), std::string::npos);
}

}  // namespace
}  // namespace cpt::validation::paper

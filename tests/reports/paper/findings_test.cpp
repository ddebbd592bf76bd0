#include "reports/paper/findings.hpp"

#include <gtest/gtest.h>

#include <set>

#include "reports/paper/compare.hpp"
#include "tests/reports/paper/paper_campaigns.hpp"

namespace cpt::reports::paper {
namespace {

const Finding& find(const std::vector<Finding>& findings, std::string_view row, std::string_view quantity) {
  for (const Finding& finding : findings)
    if (finding.row == row && finding.quantity.find(quantity) != std::string::npos) return finding;
  ADD_FAILURE() << row << " " << quantity;
  return findings.front();
}

TEST(Compare, LevelHoldsWithinTenPercent) {
  const Published paper{1000, "5"};
  EXPECT_EQ(compare_level({"S1", "q", "quick"}, paper, {1099, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_level({"S1", "q", "quick"}, paper, {901, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_level({"S1", "q", "quick"}, paper, {1101, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_level({"S1", "q", "quick"}, paper, {899, {}}).verdict, Verdict::differs);
  const Finding told = compare_level({"S1", "q", "quick"}, paper, {950, {}});
  EXPECT_EQ(told.published, "1000 kPa");
  EXPECT_EQ(told.ours, "950.0 kPa");
  EXPECT_EQ(told.difference, "−5.0 %");
  EXPECT_EQ(told.section, "5");
  EXPECT_EQ(told.preset, "quick");
  EXPECT_EQ(compare_level({"S1", "q", ""}, paper, {0, "x has not been run"}).verdict, Verdict::not_run);
}

TEST(Compare, EffectNeedsTheSignToo) {
  const Published paper{0.04, "6"};
  EXPECT_EQ(compare_effect({"M1", "q", ""}, paper, {0.08, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_effect({"M1", "q", ""}, paper, {-0.005, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_effect({"M1", "q", ""}, paper, {0.10, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_effect({"M1", "q", ""}, paper, {0.08, {}}).difference, "+4.0 points");
}

TEST(Compare, FarLessIsLessThanAPart) {
  EXPECT_EQ(compare_less({"L3", "SI", ""}, "less", "6", {0.09, {}}, {0.1, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_less({"S5", "SI", ""}, "far less", "6", {0.09, {}}, {0.1, {}}, 0.5).verdict,
            Verdict::differs);
  EXPECT_EQ(compare_less({"S5", "SI", ""}, "far less", "6", {0.04, {}}, {0.1, {}}, 0.5).verdict,
            Verdict::holds);
}

TEST(Findings, SandOfThePapersShapeHoldsAllItsChecks) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  for (const Finding& f : sand_findings(studies)) {
    if (f.row == "S5") continue;
    EXPECT_TRUE(f.verdict == Verdict::holds || f.verdict == Verdict::shown)
        << f.row << " " << f.quantity << ": " << f.ours << " " << f.detail;
    EXPECT_FALSE(f.ours.empty()) << f.quantity;
    EXPECT_EQ(f.preset, "quick");
  }
}

// The made-up sand behaves behind the flexible wall as behind the rigid one, which the paper's does not.
TEST(Findings, AWrongSignDiffers) {
  const PaperCampaigns campaigns;
  const auto findings = sand_findings(campaigns.studies());
  EXPECT_EQ(find(findings, "S4", "σ'").verdict, Verdict::holds);
  EXPECT_EQ(find(findings, "S5", "15 → 35").verdict, Verdict::differs);
  EXPECT_EQ(find(findings, "S4", "radius").verdict, Verdict::holds);
  EXPECT_EQ(find(findings, "S5", "radius").verdict, Verdict::differs);
}

TEST(Findings, RangeLeavesOutTheHardSandButCountsWhatIsMissing) {
  const PaperCampaigns complete;
  const PaperCampaigns partial({{sand_study, {{21, "did_not_converge"}}}});
  const auto whole = sand_findings(complete.studies()), part = sand_findings(partial.studies());
  EXPECT_EQ(find(whole, "S1", "largest").detail, "");
  EXPECT_EQ(find(whole, "S1", "largest").ours.substr(0, 2), "47");  // chi 3.5: 1.21 times 3.9 MPa
  EXPECT_EQ(find(part, "S1", "largest").detail, "19 of 20 realizations are in the range");
}

TEST(Findings, SecondPushIsHeldAgainstTheFirst) {
  const PaperCampaigns campaigns;
  const auto findings = chamber_findings(campaigns.studies());
  // The made-up second push has the first one's curve: no effect of stress, 20 % of density.
  const Finding& stress = find(findings, "M1", "120");
  EXPECT_TRUE(stress.ours == "+0.0 %" || stress.ours == "−0.0 %") << stress.ours;
  EXPECT_EQ(stress.verdict, Verdict::differs);
  EXPECT_EQ(find(findings, "M2", "60 → 65").verdict, Verdict::differs);
  EXPECT_EQ(find(findings, "M2", "multiplied").ours.substr(0, 2), "+2");
  EXPECT_EQ(find(findings, "B1", "rigid wall").verdict, Verdict::holds);
  EXPECT_EQ(find(findings, "B1", "flexible wall").verdict, Verdict::differs);
}

TEST(Findings, EveryRowIsThereWhetherRunOrNot) {
  const std::set<std::string_view> rows = {"S1", "S2", "S3", "S4", "S5", "C1", "C2", "L1",
                                           "L2", "L3", "B1", "W1", "M1", "M2", "D1", "F9"};
  const PaperCampaigns campaigns;
  Studies one = campaigns.studies();
  std::erase_if(one, [](const auto& study) { return study.first != clay_study; });
  for (const Studies& studies : {campaigns.studies(), one}) {
    std::set<std::string_view> found;
    for (const Finding& f : all_findings(studies)) {
      found.insert(f.row);
      EXPECT_FALSE(f.published.empty()) << f.quantity;
      EXPECT_FALSE(f.section.empty()) << f.quantity;
      EXPECT_EQ(f.verdict == Verdict::not_run, f.ours.empty()) << f.row << " " << f.quantity;
      EXPECT_TRUE(f.verdict != Verdict::not_run || !f.detail.empty()) << f.row << " " << f.quantity;
    }
    EXPECT_EQ(found, rows);
  }
  EXPECT_EQ(find(all_findings(one), "S2", "H = 75").detail, "homogeneous_sand has not been run");
  EXPECT_EQ(find(all_findings(one), "C1", "baseline").verdict, Verdict::holds);
}

TEST(Findings, ARunThatWaitsOrFailedIsNamed) {
  const PaperCampaigns campaigns(
      {{clay_study, {{1, "pending"}}}, {dense_rigid_study, {{2, "energy_drift"}}}});
  const Studies studies = campaigns.studies();
  EXPECT_EQ(find(clay_findings(studies), "C1", "baseline").detail,
            "homogeneous_clay: realization 1 has not been run");
  EXPECT_EQ(find(chamber_findings(studies), "B1", "rigid wall").detail,
            "dense_rigid: realization 2 failed (energy_drift: energy error 0.31 at 0.212 m exceeds 0.1)");
}

}  // namespace
}  // namespace cpt::reports::paper

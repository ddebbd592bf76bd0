#include "validation/paper/findings.hpp"

#include <gtest/gtest.h>

#include "tests/validation/paper/paper_campaigns.hpp"
#include "validation/paper/compare.hpp"

namespace cpt::validation::paper {
namespace {

std::vector<Finding> flat(const std::vector<FindingGroup>& groups) {
  std::vector<Finding> all;
  for (const FindingGroup& group : groups)
    all.insert(all.end(), group.findings.begin(), group.findings.end());
  return all;
}

const Finding& find(const std::vector<Finding>& findings, std::string_view row, std::string_view quantity) {
  for (const Finding& finding : findings)
    if (finding.row == row && finding.quantity.find(quantity) != std::string::npos) return finding;
  ADD_FAILURE() << row << " " << quantity;
  return findings.front();
}

TEST(Compare, LevelHoldsWithinTenPercent) {
  const Published paper{1000, "5"};
  EXPECT_EQ(compare_level({"S1", "q"}, paper, {1099, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_level({"S1", "q"}, paper, {901, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_level({"S1", "q"}, paper, {1101, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_level({"S1", "q"}, paper, {899, {}}).verdict, Verdict::differs);
  const Finding told = compare_level({"S1", "q"}, paper, {950, {}});
  EXPECT_EQ(told.published, "1000 kPa");
  EXPECT_EQ(told.ours, "950.0 kPa");
  EXPECT_EQ(told.difference, "−5.0 %");
  EXPECT_EQ(told.section, "5");
  EXPECT_EQ(compare_level({"S1", "q"}, paper, {0, "x has not been run"}).verdict, Verdict::not_run);
}

TEST(Compare, EffectNeedsTheSignToo) {
  const Published paper{0.04, "6"};
  EXPECT_EQ(compare_effect({"M1", "q"}, paper, {0.08, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_effect({"M1", "q"}, paper, {-0.005, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_effect({"M1", "q"}, paper, {0.10, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_effect({"M1", "q"}, paper, {0.08, {}}).difference, "+4.0 points");
}

TEST(Compare, StressRisesByTheStressNotTheRise) {
  const Published paper{0.2, "6"};
  EXPECT_EQ(compare_stress_rise({"W1", "s"}, paper, {0.31, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_stress_rise({"W1", "s"}, paper, {0.33, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_stress_rise({"W1", "s"}, {0.05, "6"}, {-0.01, {}}).verdict, Verdict::differs);
  EXPECT_EQ(compare_nearer({"W1", "s"}, "near 1", {1.0, "6"}, {0.5, "6"}, {0.76, {}}).verdict,
            Verdict::holds);
  EXPECT_EQ(compare_nearer({"W1", "s"}, "near 1", {1.0, "6"}, {0.5, "6"}, {1.6, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_change({"D1", "e"}, "less", "6", Sign::falls, {0.01, {}}, 3).ours, "+0.010");
  EXPECT_EQ(compare_change({"D1", "e"}, "less", "6", Sign::falls, {0.01, {}}, 3).verdict, Verdict::differs);
}

TEST(Compare, FarLessIsLessThanAPart) {
  EXPECT_EQ(compare_less({"L3", "SI"}, "less", "6", {0.09, {}}, {0.1, {}}).verdict, Verdict::holds);
  EXPECT_EQ(compare_less({"S5", "SI"}, "far less", "6", {0.09, {}}, {0.1, {}}, 0.5).verdict,
            Verdict::differs);
  EXPECT_EQ(compare_less({"S5", "SI"}, "far less", "6", {0.04, {}}, {0.1, {}}, 0.5).verdict, Verdict::holds);
}

TEST(Findings, SandOfThePapersShapeHoldsAllItsChecks) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  for (const Finding& f : sand_findings(studies)) {
    if (f.row == "S5") continue;
    EXPECT_TRUE(f.verdict == Verdict::holds || f.verdict == Verdict::shown)
        << f.row << " " << f.quantity << ": " << f.ours << " " << f.detail;
    EXPECT_FALSE(f.ours.empty()) << f.quantity;
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
  const auto findings = chamber_findings({campaigns.studies(), {}});
  // The made-up second push has the first one's curve: no effect of stress, 20 % of density.
  const Finding& stress = find(findings, "M1", "120");
  EXPECT_TRUE(stress.ours == "+0.0 %" || stress.ours == "−0.0 %") << stress.ours;
  EXPECT_EQ(stress.verdict, Verdict::differs);
  EXPECT_EQ(find(findings, "M2", "60 → 65").verdict, Verdict::differs);
  EXPECT_EQ(find(findings, "M2", "multiplied").ours.substr(0, 2), "+2");
  EXPECT_EQ(find(findings, "B1", "q<sub>c</sub>, rigid wall").verdict, Verdict::holds);
  EXPECT_EQ(find(findings, "B1", "q<sub>c</sub>, flexible wall").verdict, Verdict::differs);
}

TEST(Findings, HaveAValueOrAReason) {
  const PaperCampaigns campaigns;
  Studies one = campaigns.studies();
  std::erase_if(one, [](const auto& study) { return study.first != clay_study; });
  for (const Studies& studies : {campaigns.studies(), one})
    for (const Finding& f : flat(all_findings({studies, {}}))) {
      EXPECT_FALSE(f.published.empty()) << f.quantity;
      EXPECT_FALSE(f.section.empty()) << f.quantity;
      const bool nothing = f.verdict == Verdict::not_run || f.verdict == Verdict::not_published;
      EXPECT_EQ(nothing, f.ours.empty()) << f.row << " " << f.quantity;
      EXPECT_TRUE(!nothing || !f.detail.empty()) << f.row << " " << f.quantity;
    }
  EXPECT_EQ(find(sand_findings(one), "S2", "H = 75").detail, "homogeneous_sand has not been run");
  EXPECT_EQ(find(clay_findings(one), "C1", "baseline").verdict, Verdict::holds);
}

TEST(Findings, ARunThatWaitsOrFailedIsNamed) {
  const PaperCampaigns campaigns(
      {{clay_study, {{1, "pending"}}}, {dense_rigid_study, {{2, "energy_drift"}}}});
  const Studies studies = campaigns.studies();
  EXPECT_EQ(find(clay_findings(studies), "C1", "baseline").detail,
            "homogeneous_clay: realization 1 has not been run");
  EXPECT_EQ(find(chamber_findings({studies, {}}), "B1", "q<sub>c</sub>, rigid wall").detail,
            "dense_rigid: realization 2 failed (energy_drift: energy error 0.31 at 0.212 m exceeds 0.1)");
}

}  // namespace
}  // namespace cpt::validation::paper

// Recorded pushes: which count, what is measured on them, and their figures.
#include "validation/paper/pushes.hpp"

#include <gtest/gtest.h>

#include "tests/validation/paper/paper_campaigns.hpp"
#include "validation/paper/figures.hpp"
#include "validation/paper/findings.hpp"
#include "validation/paper/push_measures.hpp"

namespace cpt::validation::paper {
namespace {

namespace fs = std::filesystem;
using reports::NamedFigure;
using results::Histories;

// Stresses grow from `p` and `q` [kPa] to ten times as much; the wall's by 20 % and 240 %; the soil beside
// the cone dilates, contracts from there to 0.24 m, and stays as it is beyond.
Push made_up(double p, double q) {
  Histories h;
  h.tip_depth = {0.02, 0.36, 0.70};
  for (const double r : {0.01265, 0.0253, 0.03795})
    h.points.push_back(
        {{r, 0.5},
         {r, 0.5},
         1,
         "sand",
         {{"p", {"Pa", {p * 1e3, p * 5e3, p * 1e4}}}, {"q", {"Pa", {q * 1e3, q * 5e3, q * 1e4}}}}});
  h.walls.push_back(
      {{0.45, 0.55},
       3,
       {{"sigma_v", {"Pa", {100e3, 120e3, 110e3}}}, {"sigma_r", {"Pa", {50e3, 150e3, 170e3}}}}});
  for (double r = 0.0130; r < 0.45; r += 0.002)
    for (double depth = 0.01; depth < 1.0; depth += 0.02) {
      h.end.r.push_back(r);
      h.end.depth.push_back(depth);
      h.end.volume.push_back(r);
      h.end.void_ratio_start.push_back(0.687);
      h.end.void_ratio.push_back(r < 0.0152 ? 0.700 : r < 0.24 ? 0.687 - 0.018 * (0.24 - r) / 0.225 : 0.687);
    }
  h.origin = {{"status", "completed"}};
  return {h, {}};
}

TEST(PushMeasures, AreThoseOfTheMadeUpPush) {
  const Push push = made_up(66.7, 50.0), same = made_up(66.7, 50.0), twice = made_up(133.4, 100.0);
  EXPECT_EQ(path_distance(push, same, 1).number, 0.0);
  EXPECT_NEAR(path_distance(push, twice, 3).number, 1.0, 1e-12);
  EXPECT_NEAR(mean_stress_change(push, twice, 2).number, 1.0, 1e-12);
  EXPECT_FALSE(path_distance(push, twice, 4)) << "no point at 4 cone radii";
  EXPECT_NEAR(largest_wall_rise(push, "sigma_v").number, 0.20, 1e-12);
  EXPECT_NEAR(largest_wall_rise(push, "sigma_r").number, 2.40, 1e-12);
  EXPECT_NEAR(final_wall_ratio(push).number, 170.0 / 110.0, 1e-12);
  EXPECT_NEAR(change_beside_cone(push).number, 0.013, 1e-3);
  EXPECT_NEAR(largest_contraction(push).number, -0.018, 1e-3);
  EXPECT_NEAR(least_point_void_ratio(push).number, 0.669, 1e-3);
  // A tenth of the largest contraction is left at nine tenths of the way.
  EXPECT_NEAR(altered_radius(push).number, 0.24 - 0.0225, 0.003);
}

TEST(PushMeasures, SayWhyThereAreNone) {
  const Push none{std::nullopt, "not recorded"};
  for (const Value& value : {path_distance(made_up(1, 1), none, 1), largest_wall_rise(none, "sigma_v"),
                             altered_radius(none), least_point_void_ratio(none)}) {
    EXPECT_FALSE(value);
    EXPECT_EQ(value.missing, "not recorded");
  }
  Push early = made_up(1, 1);
  early.histories->end = {};
  early.histories->walls.clear();
  EXPECT_FALSE(altered_radius(early));
  EXPECT_FALSE(least_point_void_ratio(early));
  EXPECT_FALSE(final_wall_ratio(early));
}

TEST(PushFindings, APushOfThePapersShapeHoldsItsChecks) {
  const Pushes pushes{made_up(66.7, 50.0), made_up(66.0, 50.0), made_up(66.7, 50.0), made_up(93.3, 60.0)};
  for (const auto& findings : {path_findings(pushes), wall_findings(pushes), void_ratio_findings(pushes)})
    for (const Finding& f : findings) {
      if (f.quantity.find("<sub>v</sub> at the wall, at the end") != std::string::npos) continue;  // 1.55
      EXPECT_TRUE(f.verdict == Verdict::holds || f.verdict == Verdict::shown) << f.row << " " << f.quantity;
    }
}

TEST(PushFigures, AreDrawnAsFarAsThePushesAreThere) {
  Pushes pushes{made_up(66.7, 50.0), made_up(93.3, 10.0), made_up(66.7, 50.0), made_up(93.3, 10.0)};
  for (const NamedFigure& figure : push_figures(pushes)) {
    ASSERT_TRUE(figure.svg) << figure.name;
    EXPECT_EQ(figure.svg->find("nan"), std::string::npos) << figure.name;
    EXPECT_LT(figure.svg->size(), 400000u) << figure.name;
  }
  pushes.flexible = {std::nullopt, "not recorded"};
  EXPECT_FALSE(push_figures(pushes)[0].svg);
  EXPECT_TRUE(push_figures(pushes)[1].svg);
  pushes.rigid = {std::nullopt, "not recorded"};
  for (const NamedFigure& figure : push_figures(pushes)) EXPECT_FALSE(figure.svg) << figure.name;
}

TEST(Pushes, CountOnlyWithTheSettingsOfTheirRealization) {
  const PaperCampaigns campaigns;
  const Studies studies = campaigns.studies();
  EXPECT_EQ(read_pushes(campaigns.folder(), studies).rigid.missing,
            "the push of dense_rigid, realization 1, has not been recorded");

  const fs::path folder = campaigns.folder() / "dense_flexible-2-push";
  fs::create_directories(folder);
  Histories h = *made_up(66.7, 50.0).histories;
  const auto record = [&](const std::string& hash, const std::string& status) {
    h.origin["settings_hash"] = hash;
    h.origin["status"] = status;
    results::write_histories(folder / "dense_flexible-2-histories.h5", h);
    return read_pushes(campaigns.folder(), studies).flexible_90;
  };
  const std::string& hash = studies.find(dense_flexible_study)->second.realizations.at(1).settings_hash;
  const Push push = record(hash, "completed");
  ASSERT_TRUE(push.histories) << push.missing;
  EXPECT_EQ(push.histories->end, h.end);
  EXPECT_NE(record("0123", "completed").missing.find("has other settings"), std::string::npos);
  EXPECT_NE(record(hash, "energy_drift").missing.find("ended early (energy_drift)"), std::string::npos);
}

}  // namespace
}  // namespace cpt::validation::paper

// q_t, I_c and zones against values calculated by hand from the published equations; intervals of zones.
#include "recordings/soil_behaviour.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "recordings/behaviour_intervals.hpp"

namespace cpt::recordings {
namespace {

constexpr double kPa = 1.0e3;

TEST(SoilBehaviour, CorrectedResistance) {
  EXPECT_NEAR(corrected_resistance(600 * kPa, 300 * kPa, 0.85), 645 * kPa, 1e-6);
  EXPECT_NEAR(corrected_resistance(600 * kPa, -20 * kPa, 0.8), 596 * kPa, 1e-6);
  EXPECT_TRUE(std::isnan(corrected_resistance(600 * kPa, not_given, 0.8)));
}

TEST(SoilBehaviour, StressesOfTheGround) {
  const GroundModel model{19e3, 2.0, 0.0};
  const Ground deep = ground_at(10.0, model);
  EXPECT_NEAR(deep.sigma_v0, 190 * kPa, 1e-6);
  EXPECT_NEAR(deep.effective_sigma_v0, 190 * kPa - 8 * 9.81 * kPa, 1e-6);
  EXPECT_NEAR(ground_at(1.0, model).effective_sigma_v0, 19 * kPa, 1e-6);  // dry above the table
  EXPECT_NEAR(ground_at(0.5, {18e3, 5.0, 50e3}).effective_sigma_v0, 59 * kPa, 1e-6);
  EXPECT_NEAR(ground_at(0.0, {18e3, -3.0, 40e3}).effective_sigma_v0, 40 * kPa - 3 * 9.81 * kPa, 1e-6);
}

// q_t - sigma_v0 = 2400 kPa over sigma'_v0 = 60 kPa: Q = 40; F = 100 50/2400 = 2.0833 %.
// sqrt((3.47 - 1.60206)^2 + (1.22 + 0.31876)^2) = sqrt(3.48920 + 2.36777) = 2.42012
TEST(SoilBehaviour, RobertsonOf1990) {
  const Behaviour b = behaviour_1990(2500 * kPa, 50 * kPa, {100 * kPa, 60 * kPa});
  EXPECT_NEAR(b.Q_tn, 40.0, 1e-9);
  EXPECT_NEAR(b.F_r, 2.08333, 1e-5);
  EXPECT_NEAR(b.I_c, 2.42012, 1e-5);
  EXPECT_EQ(b.n, 1.0);
  EXPECT_EQ(b.zone, 5);
}

// Values of the turns "I_c from n, n from I_c" gone on with until nothing changed, in another program.
TEST(SoilBehaviour, RobertsonOf2009) {
  const Behaviour silt = behaviour_2009(2500 * kPa, 50 * kPa, {100 * kPa, 60 * kPa});
  EXPECT_NEAR(silt.Q_tn, 36.378843, 1e-5);
  EXPECT_NEAR(silt.n, 0.814238, 1e-6);
  EXPECT_NEAR(silt.I_c, 2.452068, 1e-6);
  // What the three must fulfil.
  EXPECT_NEAR(silt.n, 0.381 * silt.I_c + 0.05 * 0.6 - 0.15, 1e-9);
  EXPECT_NEAR(silt.Q_tn, 24.0 * std::pow(100.0 / 60.0, silt.n), 1e-9);
  const Behaviour sand = behaviour_2009(12000 * kPa, 60 * kPa, {190 * kPa, 111.52 * kPa});
  EXPECT_NEAR(sand.Q_tn, 111.190904, 1e-5);
  EXPECT_NEAR(sand.n, 0.552885, 1e-6);
  EXPECT_NEAR(sand.I_c, 1.698491, 1e-6);
  EXPECT_EQ(sand.zone, 6);
  const Behaviour clay = behaviour_2009(600 * kPa, 15 * kPa, {150 * kPa, 81.33 * kPa});
  EXPECT_EQ(clay.n, 1.0) << "never more";
  EXPECT_NEAR(clay.I_c, 3.236412, 1e-6);
  EXPECT_EQ(clay.zone, 3);
}

TEST(SoilBehaviour, TheExponentIsFoundWhereTheTurnsSwing) {
  // sigma'_v0 = 0.05 kPa: each turn throws n further.
  const Behaviour b = behaviour_2009(500 * kPa, 5 * kPa, {0.05 * kPa, 0.05 * kPa});
  EXPECT_NEAR(b.n, 0.381 * b.I_c + 0.05 * 0.0005 - 0.15, 1e-9);
}

TEST(SoilBehaviour, WhereThereIsNoIndex) {
  EXPECT_EQ(behaviour_2009(90 * kPa, 5 * kPa, {100 * kPa, 60 * kPa}).zone, 0) << "q_t below sigma_v0";
  EXPECT_EQ(behaviour_2009(900 * kPa, 0.0, {100 * kPa, 60 * kPa}).zone, 0);
  EXPECT_EQ(behaviour_2009(900 * kPa, -1.0, {100 * kPa, 60 * kPa}).zone, 0);
  EXPECT_EQ(behaviour_2009(900 * kPa, 5 * kPa, {10 * kPa, -5 * kPa}).zone, 0);
  EXPECT_EQ(behaviour_2009(not_given, 5 * kPa, {10 * kPa, 5 * kPa}).zone, 0);
  EXPECT_EQ(behaviour_2009(900 * kPa, not_given, {10 * kPa, 5 * kPa}).zone, 0);
}

TEST(SoilBehaviour, ZonesOfTheChart) {
  EXPECT_EQ(behaviour_zone(300, 0.3), 7);  // I_c 1.21
  EXPECT_EQ(behaviour_zone(100, 1.0), 6);  // 1.91
  EXPECT_EQ(behaviour_zone(40, 2.0), 5);   // 2.41
  EXPECT_EQ(behaviour_zone(20, 2.5), 4);   // 2.71
  EXPECT_EQ(behaviour_zone(8, 4.0), 3);    // 3.15
  EXPECT_EQ(behaviour_zone(2, 6.0), 2);    // 3.75
  EXPECT_EQ(behaviour_zone(5, 0.3), 1);    // 12 exp(-0.42) = 7.9
  EXPECT_EQ(behaviour_zone(8, 0.3), 4);    // just beyond; I_c 2.67
  // At F = 3 %: 1/(0.01 - 0.0012 - 0.002) = 147.06
  EXPECT_EQ(behaviour_zone(147.0, 3.0), 5);
  EXPECT_EQ(behaviour_zone(147.1, 3.0), 8);
  // At F = 6 %: 1/(0.025 - 0.0075 - 0.002) = 64.5
  EXPECT_EQ(behaviour_zone(64.0, 6.0), 4);
  EXPECT_EQ(behaviour_zone(65.0, 6.0), 9);
  EXPECT_EQ(behaviour_zone(1200.0, 1.6), 8);  // beyond 1/0.000892 = 1121
  EXPECT_EQ(behaviour_zone(1200.0, 1.4), 6) << "8 begins at 1.5 %";
  EXPECT_EQ(name_of_zone(3), "clays: silty clay to clay");
}

BehaviourProfile profile(const std::vector<int>& zones) {
  BehaviourProfile p;
  for (std::size_t i = 0; i < zones.size(); ++i) {
    Behaviour b;
    b.zone = zones[i];
    if (b.zone > 0) b.I_c = 5.0 - 0.5 * b.zone;
    p.depth.push_back(0.1 * static_cast<double>(i));
    p.q_t.push_back(1e6 * static_cast<double>(i));
    p.R_f.push_back(1.0);
    p.behaviour.push_back(b);
  }
  return p;
}

TEST(BehaviourIntervals, RunsOfAZoneMeetHalfWayBetweenReadings) {
  const auto intervals = behaviour_intervals(profile({3, 3, 3, 6, 6, 6, 6}), 0.15);
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_NEAR(intervals[0].from, 0.0, 1e-12);
  EXPECT_NEAR(intervals[0].to, 0.25, 1e-12);
  EXPECT_NEAR(intervals[1].to, 0.6, 1e-12);
  EXPECT_EQ(intervals[0].zone, 3);
  EXPECT_EQ(intervals[1].zone, 6);
  EXPECT_NEAR(intervals[1].q_t, 4.5e6, 1e-6);
  EXPECT_EQ(intervals[1].readings, 4);
}

TEST(BehaviourIntervals, ThinOnesJoinTheNearerNeighbour) {
  // One reading of 5 between 3 and 6 is nearer to 6; one of 4 within 3 leaves one interval.
  const auto intervals = behaviour_intervals(profile({3, 3, 4, 3, 3, 5, 6, 6, 6}), 0.15);
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_EQ(intervals[0].zone, 3);
  EXPECT_EQ(intervals[0].readings, 5);
  EXPECT_EQ(intervals[0].of_zone, 4);
  EXPECT_NEAR(intervals[0].to, 0.45, 1e-12);
  EXPECT_EQ(intervals[1].readings, 4);
}

TEST(BehaviourIntervals, ReadingsWithoutAZonePartOthersOnlyWhereTheyAreMany) {
  EXPECT_EQ(behaviour_intervals(profile({3, 3, 0, 3, 3}), 0.15).size(), 1U);
  const auto parted = behaviour_intervals(profile({3, 3, 0, 0, 0, 3, 3}), 0.15);
  ASSERT_EQ(parted.size(), 2U);
  EXPECT_NEAR(parted[0].to, 0.15, 1e-12);
  EXPECT_NEAR(parted[1].from, 0.45, 1e-12);
  EXPECT_TRUE(behaviour_intervals(profile({0, 0, 0}), 0.15).empty());
  EXPECT_TRUE(behaviour_intervals({}, 0.15).empty());
  EXPECT_EQ(behaviour_intervals(profile({4}), 0.15).size(), 1U);
}

TEST(BehaviourIntervals, CoverAllReadingsOnce) {
  std::vector<int> zones;
  for (int i = 0; i < 500; ++i) zones.push_back(2 + (i * i / 7 + i) % 5);
  const auto intervals = behaviour_intervals(profile(zones), 1.0);
  int readings = 0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    readings += intervals[i].readings;
    if (i > 0) {
      EXPECT_NEAR(intervals[i].from, intervals[i - 1].to, 1e-12);
      EXPECT_NE(intervals[i].zone, intervals[i - 1].zone);
    }
  }
  EXPECT_EQ(readings, 500);
  EXPECT_NEAR(intervals.back().to, 49.9, 1e-9);
}

}  // namespace
}  // namespace cpt::recordings

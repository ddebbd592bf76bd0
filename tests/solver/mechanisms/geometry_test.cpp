// Mechanisms of geometry and of the reading: depth datum, load cell, shifted and mixed interfaces, worn cone.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "solver/actual_setup.hpp"
#include "solver/mechanisms/catalogue.hpp"
#include "solver/mechanisms/reading.hpp"
#include "solver/problem.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

TEST(DepthDatum, MovesTheRecordingOnly) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.04);
  const Outcome plain = run(setup);
  setup.mechanisms.depth_datum.shift = 0.007;
  const Outcome shifted = run(setup);
  EXPECT_EQ(plain.profile.q_c, shifted.profile.q_c);
  for (std::size_t k = 0; k < plain.profile.depth.size(); ++k)
    EXPECT_DOUBLE_EQ(shifted.profile.depth[k], plain.profile.depth[k] + 0.007);
}

TEST(LoadCell, ReadsOtherwiseWhatThePushIs) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.04);
  const Outcome plain = run(setup);
  setup.mechanisms.zero_offset.offset = -20e3;
  setup.mechanisms.zero_drift.at_end = 60e3;
  setup.mechanisms.gain_drift.at_end = 0.1;
  const Outcome read = run(setup);
  EXPECT_EQ(plain.profile.f_s, read.profile.f_s);
  EXPECT_EQ(plain.profile.depth, read.profile.depth);
  for (std::size_t k = 0; k < plain.profile.depth.size(); ++k)
    EXPECT_DOUBLE_EQ(read.profile.q_c[k], plain.profile.q_c[k] * (1.0 + 0.1 * plain.profile.depth[k] / 0.04) +
                                              (-20e3 + 60e3 * plain.profile.depth[k] / 0.04));
}

TEST(SleeveLoad, LeavesTheForceOnTipAndSleeveAsItIs) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.04);
  DepthProfile pushed;
  pushed.depth = {0.01, 0.02, 0.03};
  pushed.q_c = {1e6, 5e6, 2e6};
  pushed.f_s = {0.0, 30e3, 12e3};
  EXPECT_EQ(as_recorded(pushed, setup).q_c, pushed.q_c);
  setup.mechanisms.sleeve_load.share = 0.07;
  const DepthProfile read = as_recorded(pushed, setup);
  const double d = setup.penetrometer.diameter;
  const double A_c = 0.25 * std::numbers::pi * d * d,
               A_s = std::numbers::pi * d * setup.penetrometer.sleeve_length;
  EXPECT_EQ(read.depth, pushed.depth);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(read.f_s[k], 0.93 * pushed.f_s[k]);
    EXPECT_DOUBLE_EQ(read.q_c[k] * A_c + read.f_s[k] * A_s, pushed.q_c[k] * A_c + pushed.f_s[k] * A_s);
  }
  setup.mechanisms.sleeve_load.share = 1.0;  // all of it
  EXPECT_EQ(as_recorded(pushed, setup).f_s, std::vector<double>(3, 0.0));
}

// Against the length summed over short straight pieces, and its first terms: z (1 + angle^2 / 6) at the end.
TEST(Inclination, RecordsTheLengthOfTheRods) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.5);
  DepthProfile pushed;
  pushed.depth = {0.0, 0.1, 0.3, 0.5};
  pushed.q_c = pushed.f_s = {0.0, 1e6, 2e6, 3e6};
  EXPECT_EQ(as_recorded(pushed, setup).depth, pushed.depth);
  setup.mechanisms.inclination.at_end = 0.6;
  const DepthProfile read = as_recorded(pushed, setup);
  EXPECT_EQ(read.q_c, pushed.q_c);
  for (std::size_t k = 0; k < pushed.depth.size(); ++k) {
    const int pieces = 2000;
    double length = 0.0;
    for (int i = 0; i < pieces; ++i)
      length += pushed.depth[k] / pieces / std::cos(0.6 * pushed.depth[k] * (i + 0.5) / pieces / 0.5);
    EXPECT_NEAR(read.depth[k], length, 1e-7 * length);
  }
  setup.mechanisms.inclination.at_end = 1e-3;
  EXPECT_NEAR(as_recorded(pushed, setup).depth.back() / 0.5 - 1.0, 1e-6 / 6.0, 1e-12);
}

// What the diagnosis relies on: the reading of a stored push equals a push that was read so.
TEST(Reading, OfAPlainPushIsThePushReadSo) {
  solver::Setup setup = quick(Profile::homogeneous_clay, 0.04);
  const Outcome plain = run(setup);
  for (const Mechanism& mechanism : all_mechanisms()) {
    if (!mechanism.of_reading) continue;
    solver::Setup on = setup;
    mechanism.parameters.front().quantity.set_value(on, mechanism.parameters.front().prior_upper);
    const DepthProfile read = as_recorded(plain.profile, on), run_so = run(on).profile;
    EXPECT_EQ(read.depth, run_so.depth) << mechanism.name;
    EXPECT_EQ(read.q_c, run_so.q_c) << mechanism.name;
    EXPECT_EQ(read.f_s, run_so.f_s) << mechanism.name;
  }
}

TEST(LayerShift, MovesAllInnerInterfaces) {
  solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::quick);
  const std::vector<Layer> before = setup.layers;
  setup.mechanisms.layer_shift.shift = 0.01;
  const std::vector<Layer> after = actual_setup(setup).layers;
  EXPECT_EQ(after.front().top, 0.0);
  EXPECT_EQ(after.back().bottom, before.back().bottom);
  for (std::size_t k = 0; k + 1 < before.size(); ++k) {
    EXPECT_DOUBLE_EQ(after[k].bottom, before[k].bottom + 0.01);
    EXPECT_EQ(after[k].bottom, after[k + 1].top);
  }
}

TEST(LayerThickness, MovesTheMiddleLayersInterfacesApart) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.3);
  setup.layers = {{0.0, 0.1, default_sand},
                  {0.1, 0.15, default_sand},
                  {0.15, 0.2, default_clay},
                  {0.2, 1.0, default_sand}};
  const Mechanism& mechanism = *find_mechanism("layer_thickness");
  EXPECT_TRUE(applies(mechanism, setup));
  setup.mechanisms.layer_thickness.change = 0.01;
  const solver::Setup actual = actual_setup(setup);
  EXPECT_DOUBLE_EQ(actual.layers[0].bottom, 0.1);  // the same soil on both sides is no interface
  EXPECT_DOUBLE_EQ(actual.layers[1].bottom, 0.145);
  EXPECT_DOUBLE_EQ(actual.layers[2].bottom, 0.205);
  EXPECT_EQ(actual.layers[2].top, actual.layers[1].bottom);
  EXPECT_EQ(actual.layers[3].top, actual.layers[2].bottom);
  EXPECT_EQ(actual.layers[3].bottom, 1.0);
  setup.mechanisms.layer_thickness.change = -0.06;  // nothing is left of 0.05 m
  const std::vector<Problem> found = problems(setup);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().quantity, "layer_thickness.change_mm");

  setup.layers = {{0.0, 0.2, default_sand}, {0.2, 1.0, default_clay}};
  EXPECT_FALSE(applies(mechanism, setup));  // one interface has no layer in the middle
  EXPECT_EQ(actual_setup(setup).layers[0].bottom, 0.2);
}

TEST(InterfaceMixing, SharesGoLinearlyFromOneSoilToTheOther) {
  solver::Setup setup = make_setup(Profile::layered_sand_clay, Preset::paper);
  setup.mechanisms.interface_mixing.thickness = 0.02;
  struct Share {
    int clay = 0, all = 0;
  };
  std::map<int, Share> by_slice;  // of 2 mm about the interface at 0.23 m, sand above clay
  for_initial_soil(setup, [&](const Point& point, std::int32_t material) {
    const double below = -point.z - 0.23;
    if (std::abs(below) >= 0.014) return;
    Share& share = by_slice[static_cast<int>(std::floor(below / 0.002))];
    share.clay += material == static_cast<std::int32_t>(default_clay) ? 1 : 0;
    ++share.all;
  });
  for (const auto& [slice, share] : by_slice) {
    const double below = (slice + 0.5) * 0.002;
    const double expected = std::clamp(0.5 + below / 0.02, 0.0, 1.0);
    EXPECT_NEAR(static_cast<double>(share.clay) / share.all, expected, 0.15) << below;
    if (std::abs(below) > 0.010) {
      EXPECT_EQ(share.clay, expected > 0.5 ? share.all : 0);
    }
  }
}

TEST(WornCone, IsThinnerAndBlunterThanItsDrawing) {
  solver::Setup setup = make_setup(Profile::homogeneous_clay, Preset::quick);
  setup.mechanisms.worn_cone = {0.0008, 0.2};
  const solver::Setup actual = actual_setup(setup);
  EXPECT_DOUBLE_EQ(actual.penetrometer.diameter, 0.0253 - 0.0008);
  EXPECT_DOUBLE_EQ(actual.penetrometer.apex, setup.penetrometer.apex + 0.2);
}

// q_c over the nominal area: a thinner cone of the same shape shows less by the ratio of areas.
TEST(WornCone, DividesTheForceByTheNominalArea) {
  solver::Setup setup = quick(Profile::homogeneous_clay, 0.08);
  solver::Setup thin = setup;
  thin.penetrometer.diameter = 0.0240;
  thin.numerics.for_diameter = 0.0240;  // a worn cone keeps the mesh of the new one
  setup.mechanisms.worn_cone.diameter_loss = 0.0253 - 0.0240;
  const double ratio = std::pow(0.0240 / 0.0253, 2);
  const double expected = ratio * mean_q_c(run(thin), 0.06, 0.08);
  EXPECT_NEAR(mean_q_c(run(setup), 0.06, 0.08), expected, 1e-6 * expected);
}

}  // namespace
}  // namespace cpt::solver

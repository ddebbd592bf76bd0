// Mechanisms of the initial stress: cushion transfer, overconsolidation, wall friction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/actual_setup.hpp"
#include "solver/problem.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/default_soils.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

TEST(CushionTransfer, ScalesTheStressAtTheTop) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  setup.mechanisms.cushion_transfer.loss = 0.2;
  const solver::Setup actual = actual_setup(setup);
  EXPECT_DOUBLE_EQ(actual.initial.sigma_v0, 40e3);
  EXPECT_DOUBLE_EQ(actual.initial.sigma_h0, 20e3);
  EXPECT_EQ(canonical_text(actual_setup(actual)), canonical_text(actual));
}

TEST(Overconsolidation, ScalesTheImagePressure) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  setup.mechanisms.overconsolidation.excess = 1.5;
  EXPECT_DOUBLE_EQ(sand_of(actual_setup(setup)).OCR, 2.5);
}

TEST(ActualSetup, IsTheSetupWhereNothingIsOn) {
  const solver::Setup setup = quick(Profile::layered_sand_clay, 0.1);
  EXPECT_EQ(canonical_text(actual_setup(setup)), canonical_text(setup));
}

TEST(StressRatioTrend, TurnsAboutTheMiddleOfThePush) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.4);
  setup.mechanisms.stress_ratio_trend.change = 0.3;
  for_initial_soil(setup, [&](const Point& point, std::int32_t) {
    const double factor = 1.0 + 0.3 * (std::min(-point.z, 0.4) - 0.2) / 0.4;
    EXPECT_NEAR(point.s_rr / point.s_zz, 0.5 * factor, 1e-12);
    EXPECT_EQ(point.s_rr, point.s_tt);
    EXPECT_EQ(-point.s_zz, vertical_stress(setup, point.z));        // as without
    EXPECT_EQ(-point.s_rr, horizontal_stress(setup, {}, point.z));  // what a wall holds
  });
  EXPECT_TRUE(problems(setup).empty());
  setup.mechanisms.stress_ratio_trend.change = 1.5;  // K_0 = 0.125 at the top
  const std::vector<Problem> found = problems(setup);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front().quantity, "stress_ratio_trend.change");
}

// Rows of K_0 that differ rest on each other: the wall's stress at a depth is that of the start.
TEST(StressRatioTrend, StartsInEquilibrium) {
  solver::Setup setup = quick(Profile::homogeneous_clay, 0.03);
  const double plain = mean_q_c(run(setup), 0.02, 0.03);
  setup.mechanisms.stress_ratio_trend.change = 0.4;
  for (const Wall wall : {Wall::rigid, Wall::flexible}) {
    setup.chamber.wall = wall;
    const Outcome outcome = run(setup);
    ASSERT_EQ(outcome.status, Status::completed) << outcome.reason;
    EXPECT_NEAR(mean_q_c(outcome, 0.02, 0.03), plain, 0.05 * plain);  // clay hardly feels K_0
  }
}

// Janssen's equation by fine steps of Euler's method.
TEST(WallFriction, TakesWhatJanssenSays) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  setup.mechanisms.wall_friction.coefficient = 0.4;
  const Bulk b = bulk(setup, default_sand);
  const double weight = b.rho * b.weight_ratio * gravity, R = setup.chamber.radius;
  double sigma_v = 50e3;
  const int steps = 100000;
  for (int i = 0; i < steps; ++i) sigma_v += 0.8 / steps * (weight - 2.0 * 0.4 * 0.5 * sigma_v / R);
  EXPECT_NEAR(vertical_stress(setup, -0.8), sigma_v, 1e-4 * sigma_v);
  EXPECT_LT(sigma_v, 40e3);
}

TEST(WallFriction, ShearFallsLinearlyToTheAxis) {
  solver::Setup setup = quick(Profile::homogeneous_sand, 0.1);
  setup.mechanisms.wall_friction.coefficient = 0.4;
  for_initial_soil(setup, [&](const Point& point, std::int32_t) {
    const double sigma_h = -point.s_rr, r = point.r;
    EXPECT_NEAR(point.s_rz, 0.4 * sigma_h * r / setup.chamber.radius, 1e-9 * sigma_h);
  });
}

}  // namespace
}  // namespace cpt::solver

// Whole pushes on a coarse model: the same bits for any number of threads, audits, and named failures.
#include "solver/simulate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/presets.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::solver {
namespace {

// A push of a few centimetres with few material points.
solver::Setup short_push(Profile profile) {
  solver::Setup setup = make_setup(profile, Preset::quick);
  setup.penetrometer.final_depth = 0.03;
  return setup;
}

Outcome run(const solver::Setup& setup, int threads = 1) {
  Observer observer;
  return simulate(setup, observer, {threads});
}

class EveryProfile : public ::testing::TestWithParam<Profile> {};

TEST_P(EveryProfile, GivesTheSameBitsForAnyNumberOfThreads) {
  solver::Setup setup = short_push(GetParam());
  if (GetParam() == Profile::layered_sand_clay)
    setup.layers = {{0.0, 0.03, default_sand}, {0.03, 0.06, default_clay}, {0.06, 1.0, default_sand}};
  const Outcome one = run(setup, 1), two = run(setup, 2), three = run(setup, 3);
  ASSERT_EQ(one.status, Status::completed) << one.reason;
  EXPECT_GT(one.profile.q_c.size(), 15U);
  for (const Outcome* other : {&two, &three}) {
    EXPECT_EQ(one.profile.depth, other->profile.depth);
    EXPECT_EQ(one.profile.q_c, other->profile.q_c);
    EXPECT_EQ(one.profile.f_s, other->profile.f_s);
    EXPECT_EQ(one.audit.energy_error, other->audit.energy_error);
    EXPECT_EQ(one.steps, other->steps);
  }
}

TEST_P(EveryProfile, ConservesMassAndBalancesMomentum) {
  solver::Setup setup = short_push(GetParam());
  // Past the first impact, whose impulse is large beside clay's for 0.15 m.
  setup.penetrometer.final_depth = GetParam() == Profile::homogeneous_clay ? 0.2 : 0.12;
  const Outcome outcome = run(setup);
  ASSERT_EQ(outcome.status, Status::completed) << outcome.reason;
  EXPECT_LT(outcome.audit.mass_error, 1e-12);
  EXPECT_LT(outcome.audit.momentum_error, 0.1);
  EXPECT_LT(std::abs(outcome.audit.energy_error), 0.06);
  EXPECT_EQ(outcome.audit.max_empty_cells, 0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, EveryProfile,
                         ::testing::Values(Profile::homogeneous_sand, Profile::homogeneous_clay,
                                           Profile::layered_sand_clay),
                         [](const auto& param_info) { return std::string(to_string(param_info.param)); });

TEST(Simulate, FlexibleWallAndTractionRun) {
  solver::Setup setup = short_push(Profile::homogeneous_clay);
  setup.chamber.wall = Wall::flexible;
  EXPECT_EQ(run(setup).status, Status::completed);
  setup.chamber.surcharge = SurchargeKind::traction;
  const Outcome outcome = run(setup);
  EXPECT_EQ(outcome.status, Status::completed) << outcome.reason;
}

TEST(Simulate, ImpossibleInputIsAnOutcome) {
  solver::Setup setup = short_push(Profile::homogeneous_sand);
  sand_of(setup).nu = 0.7;
  const Outcome outcome = run(setup);
  EXPECT_EQ(outcome.status, Status::invalid_parameters);
  EXPECT_NE(outcome.reason.find("sand.nu"), std::string::npos) << outcome.reason;
}

TEST(Simulate, ARunawayStateEndsTheRunWithAReason) {
  // Pushed far faster than the scaled waves travel: the work goes into kinetic energy.
  solver::Setup setup = short_push(Profile::homogeneous_clay);
  clay_of(setup).G = 1e5;
  setup.numerics.mass_scaling = 1e6;
  setup.penetrometer.speed = 0.5;
  setup.numerics.start_distance = 0.0;
  setup.penetrometer.final_depth = 0.3;
  const Outcome outcome = run(setup);
  EXPECT_TRUE(outcome.status == Status::did_not_converge || outcome.status == Status::energy_drift)
      << to_string(outcome.status) << ' ' << outcome.reason;
  EXPECT_FALSE(outcome.reason.empty());
}

TEST(Simulate, WallClockLimitEndsTheRun) {
  Observer observer;
  const Outcome outcome = simulate(short_push(Profile::homogeneous_sand), observer, {1, 0.0});
  EXPECT_EQ(outcome.status, Status::time_limit);
  EXPECT_NE(outcome.reason.find("limit"), std::string::npos);
}

TEST(Simulate, TheObserverCanStopTheRun) {
  struct Stop : Observer {
    bool stop_requested(std::string& reason) override {
      reason = "asked to";
      return true;
    }
  } stop;
  const Outcome outcome = simulate(short_push(Profile::homogeneous_sand), stop, {1});
  EXPECT_EQ(outcome.status, Status::time_limit);
  EXPECT_EQ(outcome.reason, "asked to");
}

}  // namespace
}  // namespace cpt::solver

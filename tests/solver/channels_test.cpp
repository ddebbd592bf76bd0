// What a push records beside q_c: the wall's stress against what is known of it.
#include "solver/channels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "solver/first_push.hpp"
#include "solver/initial_state.hpp"
#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {
namespace {

solver::Setup short_push(Wall wall) {
  solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  setup.chamber.wall = wall;
  setup.penetrometer.final_depth = 0.07;
  return setup;
}

DepthProfile profile_of(const solver::Setup& setup) {
  Observer observer;
  const Outcome outcome = simulate(setup, observer, {1});
  EXPECT_EQ(outcome.status, Status::completed) << outcome.reason;
  return outcome.profile;
}

double mean(const std::vector<double>& values, std::size_t from, std::size_t to) {
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(from);
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(to);
  return std::accumulate(first, last, 0.0) / static_cast<double>(to - from);
}

// A flexible wall holds its stress, whatever the push does.
TEST(WallStress, OfAFlexibleWallIsWhatItHolds) {
  const solver::Setup setup = short_push(Wall::flexible);
  const DepthProfile profile = profile_of(setup);
  ASSERT_EQ(profile.wall_stress.size(), profile.depth.size());
  for (std::size_t k = 0; k < profile.depth.size(); ++k)
    // Deep enough for all of the wall's part to lie in the soil.
    if (profile.depth[k] > 1.5 * setup.penetrometer.diameter) {
      const double held = horizontal_stress(setup, LeftBehind{}, -profile.depth[k]);
      EXPECT_NEAR(profile.wall_stress[k], held, 0.02 * held) << profile.depth[k];
    }
}

// A rigid wall takes the soil's own horizontal stress at first, and more once the push has displaced soil.
TEST(WallStress, OfARigidWallStartsAtTheSoilsAndGrows) {
  solver::Setup setup = short_push(Wall::rigid);
  setup.chamber.radius = 0.20;
  const DepthProfile profile = profile_of(setup);
  const std::size_t n = profile.depth.size();
  ASSERT_EQ(profile.wall_stress.size(), n);
  const double before = horizontal_stress(setup, LeftBehind{}, -profile.depth.front());
  EXPECT_NEAR(mean(profile.wall_stress, 0, n / 10), before, 0.25 * before);
  EXPECT_GT(mean(profile.wall_stress, n - n / 10, n), 1.05 * before);
}

TEST(Channels, AProfileIsEvenOrNot) {
  EXPECT_TRUE(is_even({{0.1, 0.2}, {1.0, 2.0}, {0.0, 0.0}, {}})) << "an earlier program knew no wall stress";
  EXPECT_TRUE(is_even({{0.1}, {1.0}, {0.0}, {5.0}}));
  EXPECT_FALSE(is_even({{0.1, 0.2}, {1.0, 2.0}, {}, {}}));
  EXPECT_FALSE(is_even({{0.1, 0.2}, {1.0, 2.0}, {0.0, 0.0}, {5.0}}));
}

}  // namespace
}  // namespace cpt::solver

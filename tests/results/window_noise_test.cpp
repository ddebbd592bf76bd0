#include "results/statistics/window_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cpt::results {
namespace {

constexpr Interval window{0.5054, 0.5255};

// A straight trend with an independent error in each bin.
solver::DepthProfile noisy(double at_window, double slope, double deviation, unsigned seed,
                           double end = 0.53) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> error(0.0, 1.0);
  solver::DepthProfile profile;
  for (double depth = 0.00025; depth < end; depth += 0.0005) {
    profile.depth.push_back(depth);
    profile.q_c.push_back(at_window + slope * (depth - 0.51545) + deviation * error(generator));
    profile.f_s.push_back(0.0);
  }
  return profile;
}

TEST(WindowNoise, IsTheDeviationOfOneAverage) {
  // 40 bins a window: an average of independent errors deviates by 1/sqrt(40) of one.
  constexpr double deviation = 50.0e3;
  double variance = 0.0;
  constexpr int curves = 200;
  for (unsigned seed = 0; seed < curves; ++seed) {
    const auto noise = window_noise(noisy(4.0e6, 2.0e6, deviation, seed), window);
    ASSERT_TRUE(noise);
    EXPECT_EQ(noise->freedom, 8);
    variance += noise->deviation * noise->deviation / curves;
  }
  EXPECT_NEAR(std::sqrt(variance), deviation / std::sqrt(40.0), 0.05 * deviation / std::sqrt(40.0));
}

TEST(WindowNoise, DoesNotTakeATrendForNoise) {
  const auto noise = window_noise(noisy(4.0e6, 3.0e6, 0.0, 1), window);
  ASSERT_TRUE(noise);
  EXPECT_LT(noise->deviation, 1.0);
}

TEST(WindowNoise, WantsSixWindows) {
  EXPECT_FALSE(window_noise(noisy(4.0e6, 0.0, 1.0e3, 1), {0.1, 0.5}));
  EXPECT_FALSE(window_noise({}, window));
  EXPECT_FALSE(window_noise(noisy(4.0e6, 0.0, 1.0e3, 1, 0.3), window));  // the push ended above it
  EXPECT_TRUE(window_noise(noisy(4.0e6, 0.0, 1.0e3, 1), {0.05, 0.1}));
}

TEST(IndexUncertainty, CoversTheTrueIndexNineteenTimesInTwenty) {
  constexpr double q_lower = 3.6e6, q_upper = 4.0e6, deviation = 80.0e3;
  constexpr double si = (q_upper - q_lower) / q_upper;
  int covered = 0;
  constexpr int pairs = 2000;
  for (unsigned seed = 0; seed < pairs; ++seed) {
    const auto lower = noisy(q_lower, 1.0e6, deviation, 2 * seed),
               upper = noisy(q_upper, 1.0e6, deviation, 2 * seed + 1);
    const double l = average(lower, window).value.mean, u = average(upper, window).value.mean;
    const double half = index_uncertainty(l, *window_noise(lower, window), u, *window_noise(upper, window));
    if (std::abs((u - l) / u - si) <= half) ++covered;
  }
  EXPECT_NEAR(covered, 0.96 * pairs, 0.02 * pairs);  // Welch's approximation is a little careful
}

}  // namespace
}  // namespace cpt::results

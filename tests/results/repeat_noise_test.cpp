#include "results/statistics/repeat_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cpt::results {
namespace {

TEST(RepeatNoise, IsTheScatterAboutTheMean) {
  const std::vector<double> numbers = {98.0, 100.0, 102.0, 104.0, 96.0};
  const auto noise = repeat_noise(numbers);
  ASSERT_TRUE(noise);
  EXPECT_EQ(noise->runs, 5);
  EXPECT_DOUBLE_EQ(noise->mean, 100.0);
  EXPECT_DOUBLE_EQ(noise->deviation, std::sqrt(10.0));
  // Student's t of 4 degrees of freedom, two-sided 95 %: 2.776.
  EXPECT_NEAR(prediction_half_width(*noise), 2.776 * std::sqrt(10.0) * std::sqrt(1.2), 0.002);
  EXPECT_NEAR(index_half_width(*noise), 2.776 * std::sqrt(10.0) * std::sqrt(2.0) / 100.0, 2e-5);
  EXPECT_FALSE(repeat_noise(std::vector<double>{98.0, 100.0}));
}

// The intervals hold what they promise.
TEST(RepeatNoise, IntervalsCover95Percent) {
  std::mt19937 random(3);
  std::normal_distribution<double> chance(100.0, 2.0);
  constexpr int trials = 4000;
  int predicted = 0, told_equal = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> numbers(7);
    for (double& number : numbers) number = chance(random);
    const auto noise = repeat_noise(numbers);
    predicted += std::abs(chance(random) - noise->mean) <= prediction_half_width(*noise) ? 1 : 0;
    const double lower = chance(random), upper = chance(random);
    told_equal += std::abs((upper - lower) / upper) <= index_half_width(*noise) ? 1 : 0;
  }
  EXPECT_NEAR(predicted / static_cast<double>(trials), 0.95, 0.015);
  EXPECT_NEAR(told_equal / static_cast<double>(trials), 0.95, 0.015);
}

// Of an index, too, whatever its size: rows far from 0 scatter less or more than one at 0, by q_lower /
// q_upper.
TEST(RepeatNoise, IntervalsOfIndicesCoverThem) {
  std::mt19937 random(5);
  std::normal_distribution<double> chance(1.0, 0.02);
  constexpr int trials = 4000;
  for (const auto& [lower, upper] : {std::pair{100.0, 100.0}, {100.0, 200.0}, {140.0, 100.0}}) {
    int held = 0;
    double width = 0.0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> numbers(7);
      for (double& number : numbers) number = 100.0 * chance(random);
      const auto noise = repeat_noise(numbers);
      const double q_lower = lower * chance(random), q_upper = upper * chance(random);
      const double half = index_half_width(*noise, q_lower, q_upper);
      held += std::abs((upper - lower) / upper - (q_upper - q_lower) / q_upper) <= half ? 1 : 0;
      width += half / trials;
    }
    EXPECT_NEAR(held / static_cast<double>(trials), 0.95, 0.015) << upper;
    // t of 6 degrees of freedom 2.447; the mean of s is 0.96 of sigma.
    EXPECT_NEAR(width, 2.447 * 0.96 * 0.02 * std::sqrt(2.0) * lower / upper, 0.002) << upper;
  }
}

TEST(RepeatNoise, RoundingIsNoScatter) {
  EXPECT_EQ(repeat_noise(std::vector<double>{815.15, 815.15 + 1e-10, 815.15 - 1e-10})->deviation, 0.0);
}

}  // namespace
}  // namespace cpt::results

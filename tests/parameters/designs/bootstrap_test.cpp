#include "parameters/designs/bootstrap.hpp"

#include <gtest/gtest.h>

#include <random>

namespace cpt::parameters {
namespace {

Eigen::VectorXd mean_of(const std::vector<double>& numbers, const Resample& sample) {
  double sum = 0.0;
  for (const Eigen::Index i : sample) sum += numbers[static_cast<std::size_t>(i)];
  return Eigen::VectorXd::Constant(1, sum / static_cast<double>(sample.size()));
}

// The mean of ten normal numbers: plain percentiles would hold it in 90 of 100 cases only.
TEST(Bootstrap, IntervalsHoldTheTruthAsOftenAsTheySay) {
  std::mt19937 random(5);
  std::normal_distribution<double> chance(3.0, 2.0);
  constexpr int trials = 600;
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> numbers(10);
    for (double& number : numbers) number = chance(random);
    const Estimate mean = bootstrap(10, 1000, static_cast<std::uint64_t>(trial),
                                    [&](const Resample& sample) { return mean_of(numbers, sample); })[0];
    held += mean.lower <= 3.0 && 3.0 <= mean.upper ? 1 : 0;
  }
  EXPECT_NEAR(held / static_cast<double>(trials), 0.95, 0.025);
}

TEST(Bootstrap, ValueIsThatOfAllUnitsAndTheSeedFixesTheInterval) {
  const std::vector<double> numbers = {1, 2, 3, 4, 10};
  const auto of_seed = [&](std::uint64_t seed) {
    return bootstrap(5, 200, seed, [&](const Resample& sample) { return mean_of(numbers, sample); })[0];
  };
  EXPECT_EQ(of_seed(1).value, 4.0);
  EXPECT_LT(of_seed(1).lower, 4.0);
  EXPECT_GT(of_seed(1).upper, 4.0);
  EXPECT_EQ(of_seed(1).upper, of_seed(1).upper);
  EXPECT_NE(of_seed(1).upper, of_seed(2).upper);
}

TEST(Bootstrap, FewUnitsHaveNoInterval) {
  const std::vector<double> numbers = {1, 2};
  const Estimate mean =
      bootstrap(2, 50, 1, [&](const Resample& sample) { return mean_of(numbers, sample); })[0];
  EXPECT_EQ(mean.value, 1.5);
  EXPECT_TRUE(std::isnan(mean.lower));
  EXPECT_TRUE(std::isnan(mean.upper));
}

}  // namespace
}  // namespace cpt::parameters

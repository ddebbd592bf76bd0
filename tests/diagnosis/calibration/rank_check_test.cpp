#include "diagnosis/calibration/rank_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/diagnosis/calibration/linear_problem.hpp"

namespace cpt::diagnosis {
namespace {

constexpr int draws = 99;

// 100 recordings; simulations have `factor` times the scatter that the model says.
RankCheck check_with(double factor, int threads = 1) {
  const CalibrationProblem problem = linear_problem(0.02, 0.05);
  const CalibrationModel model(problem);
  CalibrateOptions options;
  options.sampler.warm_up = 300;
  options.sampler.first_round = 1000;
  options.sampler.last_round = 4000;
  options.sampler.least_size = 150.0;
  options.sampler.most_r_hat = 1.05;
  const CalibrationChannel& channel = problem.channels.front();
  std::vector<RankCase> cases;
  for (int i = 0; i < 100; ++i) {
    Random random(40, static_cast<std::uint64_t>(i));
    const VectorXd inputs = model.values(model.draw_prior(random)).head(2);
    const VectorXd scores = linear_effects * inputs + factor * std::sqrt(linear_variance) * random.normals(2);
    const VectorXd white = factor * std::sqrt(1e-5) * random.normals(channel.mean.size());
    cases.push_back({std::to_string(i), inputs, {channel.mean + channel.shapes * scores + white}});
  }
  return rank_check(model, cases, options, 4, threads);
}

TEST(RankCheck, RanksOfTheRightModelAreUniform) {
  const RankCheck check = check_with(1.0, 2);
  const EcdfDifference band = simultaneous_band(100, draws, 0.95, 1);
  for (Index j = 0; j < 3; ++j) {
    const Eigen::VectorXi ranks = check.ranks.col(j);
    EXPECT_GT(uniformity(ranks, draws, rank_bins), 0.01) << check.unknowns[static_cast<std::size_t>(j)];
    EXPECT_TRUE(stays_within(ecdf_difference(ranks, draws, band.at), band));
  }
}

TEST(RankCheck, AModelWithTooLittleScatterIsFoundOut) {
  const RankCheck check = check_with(10.0);
  const Eigen::VectorXi ranks = check.ranks.col(0);
  const EcdfDifference band = simultaneous_band(100, draws, 0.95, 1);
  EXPECT_LT(uniformity(ranks, draws, rank_bins), 1e-3);
  EXPECT_FALSE(stays_within(ecdf_difference(ranks, draws, band.at), band));
}

TEST(RankCheck, AnyNumberOfThreadsGivesTheSame) {
  EXPECT_EQ(check_with(1.0, 1).ranks, check_with(1.0, 3).ranks);
}

TEST(RankCheck, TheBandHoldsUniformRanksAsOftenAsItSays) {
  const EcdfDifference band = simultaneous_band(50, draws, 0.95, 1);
  Random random(17, 0);
  int within = 0;
  constexpr int repetitions = 2000;
  for (int k = 0; k < repetitions; ++k) {
    Eigen::VectorXi ranks(50);
    for (int& rank : ranks) rank = static_cast<int>(random.below(draws + 1));
    within += stays_within(ecdf_difference(ranks, draws, band.at), band) ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(within) / repetitions, 0.95, 0.025);
}

TEST(RankCheck, ChiSquareOfKnownRanks) {
  Eigen::VectorXi even(100), low(100);
  for (int i = 0; i < 100; ++i) {
    even(i) = i;
    low(i) = i / 2;
  }
  EXPECT_DOUBLE_EQ(uniformity(even, draws, 10), 1.0);
  EXPECT_LT(uniformity(low, draws, 10), 1e-15);  // chi-square 100 of 9 degrees of freedom
  EXPECT_THROW((void)uniformity(even, 98, 10), std::invalid_argument);
}

TEST(RankCheck, EqualDrawsCountByChance) {
  Random random(1, 0);
  const VectorXd same = VectorXd::Constant(9, 1.0);
  double sum = 0.0;
  for (int k = 0; k < 1000; ++k) sum += rank_of(1.0, same, random);
  EXPECT_NEAR(sum / 1000.0, 4.5, 0.5);
  EXPECT_EQ(rank_of(2.0, same, random), 9);
  EXPECT_EQ(rank_of(0.0, same, random), 0);
}

}  // namespace
}  // namespace cpt::diagnosis

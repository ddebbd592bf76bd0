#include "parameters/designs/multifidelity.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "parameters/designs/propagation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A dear model of three normal inputs, and a cheap one that knows two of them.
struct Models {
  VectorXd dear, cheap;
};
Models models(std::uint64_t seed, int few, int many) {
  const boost::math::normal normal;
  const MatrixXd places = propagation_places(3, many, seed);
  Models made{VectorXd(few), VectorXd(many)};
  for (Index i = 0; i < many; ++i) {
    const auto z = [&](Index j) { return quantile(normal, places(i, j)); };
    made.cheap(i) = 5.0 + 2.0 * (z(0) + 0.6 * z(1));
    if (i < few) made.dear(i) = 10.0 + z(0) + 0.6 * z(1) + 0.2 * z(2);
  }
  return made;
}
const double true_deviation = std::sqrt(1.0 + 0.36 + 0.04);

// A cheap model that is a straight line of the dear one says the same of all its runs as the dear one would.
TEST(Multifidelity, IsThatOfAllRunsWhereTheCheapModelIsALineOfTheDearOne) {
  const VectorXd all = models(1, 400, 400).dear;
  const Levels levels = {all.head(40), 3.0 * all.array() - 7.0};
  EXPECT_NEAR(level_correlation(levels, 1), 1.0, 1e-12);
  EXPECT_NEAR(combined_mean(levels).value, all.mean(), 1e-10);
  const double squares = (all.array() - all.mean()).square().mean();
  EXPECT_NEAR(combined_deviation(levels).value, std::sqrt(squares), 1e-10);
  VectorXd sorted = all;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_NEAR(combined_quantile(levels, 0.95).value, sorted(379), 1e-10);  // the 380th of 400
  const Levels alone = {all.head(40)};
  EXPECT_NEAR(combined_mean(alone).value, all.head(40).mean(), 1e-12);
}

TEST(Multifidelity, LeavesOutWhatHasFailedAndWantsTenPairs) {
  Models m = models(2, 40, 400);
  m.dear(3) = NAN;
  m.cheap(5) = NAN;
  EXPECT_EQ(paired_runs({m.dear, m.cheap}), 38);
  EXPECT_TRUE(std::isfinite(combined_mean({m.dear, m.cheap}).upper));
  EXPECT_TRUE(std::isnan(combined_mean({m.dear.head(11), m.cheap}).value));  // nine
  EXPECT_TRUE(std::isfinite(combined_mean({m.dear.head(13), m.cheap}).value));
}

// Of the same truth, with a shorter interval, and the interval holds it; a second cheap model helps no less.
TEST(Multifidelity, IntervalsHoldTheTruthAndAreShorter) {
  const boost::math::normal normal;
  constexpr int repetitions = 200;
  int mean = 0, deviation = 0, quantile95 = 0, three = 0;
  double alone = 0.0, both = 0.0;
  for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
    const Models m = models(seed, 40, 800);
    const Levels levels = {m.dear, m.cheap};
    const auto holds = [](const Estimate& e, double truth) { return e.lower <= truth && truth <= e.upper; };
    const Estimate of_mean = combined_mean(levels);
    mean += holds(of_mean, 10.0);
    deviation += holds(combined_deviation(levels), true_deviation);
    quantile95 += holds(combined_quantile(levels, 0.95), 10.0 + quantile(normal, 0.95) * true_deviation);
    three += holds(combined_mean({m.dear, m.cheap.head(200), m.cheap}), 10.0);
    alone += by_sections(m.dear, 1, [](const VectorXd& y) { return y.mean(); }).upper - m.dear.mean();
    both += of_mean.upper - of_mean.value;
  }
  for (const int count : {mean, deviation, quantile95, three}) EXPECT_GE(count, 0.89 * repetitions);
  for (const int count : {mean, three}) EXPECT_LE(count, 0.99 * repetitions);
  EXPECT_LT(both, 0.5 * alone);
}

TEST(Multifidelity, RunsSharedOutBestBuyTheLeastVariance) {
  EXPECT_NEAR(variance_ratio(0.0, 0.1), 1.0, 1e-12);
  EXPECT_NEAR(variance_ratio(1.0, 0.1), 0.1, 1e-12);
  const double rho = 0.98, w = 0.05, ratio = best_run_ratio(rho, w);
  // Variance times cost of n dear and ratio n cheap runs, over that of dear runs alone.
  const auto product = [&](double r) { return (1.0 - rho * rho * (1.0 - 1.0 / r)) * (1.0 + w * r); };
  EXPECT_NEAR(product(ratio), variance_ratio(rho, w), 1e-12);
  EXPECT_GT(product(1.1 * ratio), product(ratio));
  EXPECT_GT(product(0.9 * ratio), product(ratio));
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/designs/shapley.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <bit>
#include <cmath>

#include "parameters/designs/propagation.hpp"
#include "parameters/designs/value_of_score.hpp"
#include "parameters/distributions/copula.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double most_score = 4.0;

// A normal input, its scores from -4 to 4 in the unit interval.
ScoredInput normal_input() {
  return {0, [](double score) { return 0.5 + 0.5 * score / most_score; }};
}

MatrixXd normal_scores(Index runs, const MatrixXd& correlation, std::uint64_t seed) {
  const auto inputs = static_cast<int>(correlation.rows());
  const MatrixXd independent =
      propagation_places(inputs, static_cast<int>(runs), seed).unaryExpr([](double p) {
        return score_of_probability(p);
      });
  return independent * MatrixXd(correlation.llt().matrixL()).transpose();
}

TEST(Shapley, SharesGainsAmongInputs) {
  // Two inputs: each has half of what it is worth alone and half of what it adds to the other.
  const VectorXd two = shapley_effects(2, Eigen::Vector4d(0.0, 0.5, 0.3, 1.0));
  EXPECT_NEAR(two(0), 0.5 * (0.5 + 0.7), 1e-15);
  EXPECT_NEAR(two(1), 0.5 * (0.3 + 0.5), 1e-15);
  // An additive game of five: each its own.
  const VectorXd own = (VectorXd(5) << 0.1, 0.3, 0.05, 0.35, 0.2).finished();
  VectorXd value(32);
  for (unsigned subset = 0; subset < 32; ++subset) {
    value(subset) = 0.0;
    for (Index j = 0; j < 5; ++j)
      if ((subset >> j & 1U) != 0U) value(subset) += own(j);
  }
  EXPECT_LT((shapley_effects(5, value) - own).norm(), 1e-14);
}

TEST(Shapley, OfCorrelatedInputsAreThoseOfTheClosedForm) {
  const MatrixXd correlation = correlated_inputs();
  for (const bool exponential : {false, true}) {
    const MatrixXd scores = normal_scores(100, correlation, 3);
    VectorXd y = scores * correlated_slope;
    if (exponential) y = y.array().exp();
    const std::vector<ScoredInput> inputs(3, normal_input());
    const auto found =
        shapley_indices((0.5 + 0.5 * scores.array() / most_score).matrix(), y, inputs, correlation, 1);
    ASSERT_EQ(found.problem, "");
    EXPECT_GT(found.q2, exponential ? 0.95 : 0.99);
    const VectorXd value = correlated_shares(exponential), shapley = shapley_effects(3, value);
    double sum = 0.0;
    for (Index j = 0; j < 3; ++j) {
      const auto at = static_cast<std::size_t>(j);
      EXPECT_NEAR(found.shapley[at].value, shapley(j), 0.015) << j;
      EXPECT_LT(found.shapley[at].lower, shapley(j)) << j;
      EXPECT_GT(found.shapley[at].upper, shapley(j)) << j;
      EXPECT_LT(found.shapley[at].upper - found.shapley[at].lower, exponential ? 0.25 : 0.05) << j;
      EXPECT_NEAR(found.first[at].value, value(Index{1} << j), 0.025) << j;
      EXPECT_NEAR(found.total[at].value, 1.0 - value(7 - (Index{1} << j)), 0.025) << j;
      sum += found.shapley[at].value;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

// Independent inputs: of every interaction its inputs have equal shares. Ishigami & Homma 1990 with a = 7, b
// = 0.1.
TEST(Shapley, OfTheIshigamiFunctionShareItsInteractions) {
  const MatrixXd places = propagation_places(3, 200, 1);
  VectorXd y(places.rows());
  for (Index i = 0; i < y.size(); ++i) y(i) = ishigami(places.row(i).transpose());
  std::vector<ScoredInput> inputs(3, {0, probability_of_score});
  const auto found = shapley_indices(places, y, inputs, MatrixXd::Identity(3, 3), 1);
  ASSERT_EQ(found.problem, "");
  EXPECT_GT(found.q2, 0.98);
  const double with_third = 0.24368, shapley[] = {0.31391 + 0.5 * with_third, 0.44241, 0.5 * with_third};
  for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found.shapley[j].value, shapley[j], 0.015) << j;
  EXPECT_NEAR(found.total[2].value, with_third, 0.02);
  EXPECT_NEAR(found.first[2].value, 0.0, 0.02);
}

TEST(Shapley, AreUndefinedWhereRunsTellNothing) {
  const std::vector<ScoredInput> two(2, {0, probability_of_score});
  const MatrixXd unit = MatrixXd::Identity(2, 2), places = propagation_places(2, 40, 1);
  const auto problem_of = [&](const VectorXd& y) { return shapley_indices(places, y, two, unit, 1).problem; };
  EXPECT_EQ(problem_of(VectorXd::Constant(40, 2.0)), "undefined: the result does not vary");
  VectorXd few = VectorXd::Constant(40, std::nan(""));
  few.head(10) = places.col(0).head(10);
  EXPECT_EQ(problem_of(few), "undefined: 10 completed runs, 2 inputs need 20");
  // Noise: no expansion, or none to be believed.
  VectorXd noise(40);
  for (Index i = 0; i < 40; ++i) noise(i) = std::sin(1e4 * places(i, 0) + 3e3 * places(i, 1));
  EXPECT_NE(problem_of(noise).find(shapley_indices(places, noise, two, unit, 1).terms > 0
                                       ? "not to be believed: Q2"
                                       : "undefined: no expansion"),
            std::string::npos);
  EXPECT_EQ(shapley_indices(places.leftCols(1), places.col(0), {two[0]}, unit.topLeftCorner(1, 1), 1).problem,
            "undefined: there is one input");
}

}  // namespace
}  // namespace cpt::parameters

#include "parameters/distributions/copula.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "parameters/designs/latin_hypercube.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

std::vector<double> ranks(const Eigen::Ref<const Eigen::VectorXd>& values) {
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::sort(order, {}, [&](Index i) { return values(i); });
  std::vector<double> found(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    found[static_cast<std::size_t>(order[k])] = static_cast<double>(k);
  return found;
}

// Spearman's.
double rank_correlation_of(const MatrixXd& places, Index a, Index b) {
  const std::vector<double> x = ranks(places.col(a)), y = ranks(places.col(b));
  const auto n = static_cast<double>(x.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += (x[i] - y[i]) * (x[i] - y[i]);
  return 1.0 - 6.0 * squares / (n * (n * n - 1.0));
}

TEST(Copula, GivesTheRankCorrelationThatWasAskedFor) {
  MatrixXd rank(3, 3);
  rank << 1.0, 0.6, -0.3, 0.6, 1.0, 0.2, -0.3, 0.2, 1.0;
  const MatrixXd places =
      dependent_places(latin_hypercube_places(3, 4000, 7), rank.unaryExpr(&score_correlation));
  for (Index a = 0; a < 3; ++a)
    for (Index b = 0; b < a; ++b) EXPECT_NEAR(rank_correlation_of(places, a, b), rank(a, b), 0.03);
  // Each by itself is still even over the unit interval.
  for (Index j = 0; j < 3; ++j) {
    EXPECT_NEAR(places.col(j).mean(), 0.5, 0.01);
    EXPECT_GT(places.col(j).minCoeff(), 0.0);
    EXPECT_LT(places.col(j).maxCoeff(), 1.0);
  }
}

TEST(Copula, LeavesIndependentInputsAsTheyAre) {
  const MatrixXd places = latin_hypercube_places(3, 50, 1);
  EXPECT_EQ(dependent_places(places, MatrixXd::Identity(3, 3)), places);
  MatrixXd some = MatrixXd::Identity(3, 3);
  some(0, 1) = some(1, 0) = 0.5;
  const MatrixXd dependent = dependent_places(places, some);
  EXPECT_EQ(dependent.col(0), places.col(0));
  EXPECT_NE(dependent.col(1), places.col(1));
  EXPECT_EQ(dependent.col(2), places.col(2));
}

TEST(Copula, RankAndScoreCorrelationAreEachOthersInverse) {
  for (const double rho : {-1.0, -0.4, 0.0, 0.3, 1.0})
    EXPECT_NEAR(rank_correlation(score_correlation(rho)), rho, 1e-12);
  EXPECT_DOUBLE_EQ(score_correlation(1.0), 1.0);
}

// The example of Higham (2002), section 4: the nearest correlation matrix of a tridiagonal one.
TEST(Copula, OffersTheNearestCorrelation) {
  MatrixXd asked(3, 3);
  asked << 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0;
  EXPECT_FALSE(positive_definite(asked));
  const MatrixXd nearest = nearest_correlation(asked);
  EXPECT_TRUE(positive_definite(nearest));
  EXPECT_NEAR(nearest(0, 1), 0.7607, 1e-4);
  EXPECT_NEAR(nearest(0, 2), 0.1573, 1e-4);
  EXPECT_EQ(nearest, MatrixXd(nearest.transpose()));
  for (Index i = 0; i < 3; ++i) EXPECT_EQ(nearest(i, i), 1.0);
}

}  // namespace
}  // namespace cpt::parameters

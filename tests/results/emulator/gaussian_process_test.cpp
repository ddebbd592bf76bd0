#include "results/emulator/gaussian_process.hpp"

#include <gtest/gtest.h>

#include "tests/results/emulator/test_functions.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

MatrixXd column(std::initializer_list<double> values) {
  MatrixXd points(static_cast<Index>(values.size()), 1);
  Index i = 0;
  for (const double value : values) points(i++, 0) = value;
  return points;
}

TEST(Matern, IsTheOneOfSmoothnessFiveHalves) {
  const double r = std::sqrt(5.0) * 0.3 / 0.5;
  const MatrixXd k = matern_5_2(column({0.2}), column({0.5, 0.2}), VectorXd::Constant(1, 0.5));
  EXPECT_DOUBLE_EQ(k(0, 0), (1.0 + r + r * r / 3.0) * std::exp(-r));
  EXPECT_DOUBLE_EQ(k(0, 1), 1.0);
  // Each input has a length of its own: 0.3 of 0.5 and 0.4 of 2 are a distance of sqrt(0.36 + 0.04).
  MatrixXd a(1, 2), b(1, 2);
  a << 0.2, 0.1;
  b << 0.5, 0.5;
  const double q = std::sqrt(5.0 * 0.4);
  EXPECT_NEAR(matern_5_2(a, b, Eigen::Vector2d(0.5, 2.0))(0, 0), (1.0 + q + q * q / 3.0) * std::exp(-q),
              1e-15);
}

TEST(Trend, HasItsTerms) {
  EXPECT_EQ(trend_terms(3, Trend::constant), 1);
  EXPECT_EQ(trend_terms(3, Trend::linear), 4);
  EXPECT_EQ(trend_terms(3, Trend::quadratic), 10);
  EXPECT_EQ(trend_for(20, 3), Trend::quadratic);
  EXPECT_EQ(trend_for(19, 3), Trend::linear);
  EXPECT_EQ(trend_for(7, 3), Trend::constant);
}

// Two runs, constant trend, worked by hand: beta is the mean by symmetry, the mean in the middle is beta, and
// with k = k(1), c = k(1/2) the variance there is s2 (1 - 2 c^2 / (1 + k) + (1 - 2 c / (1 + k))^2 (1 + k) /
// 2).
TEST(GaussianProcess, IsOrdinaryKrigingOfTwoRuns) {
  const VectorXd lengths = VectorXd::Constant(1, 0.8);
  const GaussianProcess process(column({0.0, 1.0}), Eigen::Vector2d(1.0, 3.0), Trend::constant,
                                {lengths, 0.0});
  const double k = matern_5_2(column({0.0}), column({1.0}), lengths)(0, 0);
  const double c = matern_5_2(column({0.0}), column({0.5}), lengths)(0, 0);
  EXPECT_NEAR(process.mean(column({0.5}))(0), 2.0, 1e-9);
  const double relative =
      1.0 - 2.0 * c * c / (1.0 + k) + std::pow(1.0 - 2.0 * c / (1.0 + k), 2) * (1.0 + k) / 2.0;
  EXPECT_NEAR(process.mean_variance(column({0.5}))(0), process.variance() * relative,
              1e-8 * process.variance());
  // One run predicts the other by itself: an error of 2, of variance s2 2 (1 - k). Their difference, with the
  // same variance and one degree of freedom, gives s2.
  EXPECT_NEAR(process.left_out_errors()(0), -2.0, 1e-9);
  EXPECT_NEAR(process.left_out_errors()(1), 2.0, 1e-9);
  EXPECT_NEAR(process.left_out_variances()(0), 4.0, 1e-8);
  EXPECT_NEAR(process.variance(), 4.0 / (2.0 * (1.0 - k)), 1e-7);
}

// The bordered system of universal kriging, written out (Dubrule 1983), gives the same.
TEST(GaussianProcess, IsTheSolutionOfTheBorderedSystem) {
  const MatrixXd design = hypercube(3, 25, 3), points = hypercube(3, 7, 4);
  const VectorXd y = values(ishigami, design);
  const Eigen::Vector3d lengths(0.3, 0.5, 1.0);
  const double nugget = 0.01;
  const GaussianProcess process(design, y, Trend::linear, {lengths, nugget});
  MatrixXd bordered = MatrixXd::Zero(29, 29), right(29, 7);
  bordered.topLeftCorner(25, 25) = matern_5_2(design, design, lengths);
  bordered.diagonal().head(25).array() += nugget;
  bordered.block(0, 25, 25, 1).setOnes();
  bordered.block(0, 26, 25, 3) = design;
  bordered.bottomLeftCorner(4, 25) = bordered.topRightCorner(25, 4).transpose();
  right.topRows(25) = matern_5_2(design, points, lengths);
  right.row(25).setOnes();
  right.bottomRows(3) = points.transpose();
  const MatrixXd inverse = bordered.fullPivLu().inverse();
  VectorXd padded = VectorXd::Zero(29);
  padded.head(25) = y;
  const VectorXd weights = inverse * padded;
  EXPECT_LT((process.mean(points) - right.transpose() * weights).norm(), 1e-9);
  const MatrixXd covariance =
      process.variance() * (matern_5_2(points, points, lengths) - right.transpose() * inverse * right);
  EXPECT_LT((process.mean_covariance(points, points) - covariance).norm(), 1e-8 * covariance.norm());
  EXPECT_LT((process.mean_variance(points) - covariance.diagonal()).norm(), 1e-8 * covariance.norm());
  for (Index k = 0; k < points.rows(); ++k) {
    const GaussianProcess::AtPoint one = process.at(points.row(k));
    EXPECT_NEAR(one.mean, process.mean(points)(k), 1e-10);
    EXPECT_NEAR(one.variance, covariance(k, k), 1e-8 * covariance.norm());
  }
  const VectorXd errors = weights.head(25).cwiseQuotient(inverse.diagonal().head(25));
  EXPECT_LT((process.left_out_errors() - errors).norm(), 1e-9);
}

// Dubrule's errors are those of the runs really left out.
TEST(GaussianProcess, LeavesRunsOut) {
  const MatrixXd design = hypercube(2, 18, 5);
  const VectorXd y = values([](const RowVectorXd& u) { return std::sin(5.0 * u(0)) * u(1); }, design);
  const Kernel kernel{Eigen::Vector2d(0.4, 0.7), 1e-3};
  const GaussianProcess all(design, y, Trend::quadratic, kernel);
  for (const Index out : {0, 7, 17}) {
    std::vector<Index> kept;
    for (Index i = 0; i < 18; ++i)
      if (i != out) kept.push_back(i);
    const GaussianProcess others(design(kept, Eigen::all), y(kept), Trend::quadratic, kernel);
    EXPECT_NEAR(all.left_out_errors()(out), y(out) - others.mean(design.row(out))(0), 1e-9) << out;
    const double scale = all.variance() / others.variance();
    EXPECT_NEAR(all.left_out_variances()(out),
                scale * (others.mean_variance(design.row(out))(0) + others.noise()),
                1e-8 * all.left_out_variances()(out))
        << out;
  }
}

TEST(GaussianProcess, PassesThroughRunsWithoutNoise) {
  const MatrixXd design = hypercube(3, 40, 1);
  const VectorXd y = values(ishigami, design);
  const GaussianProcess process(design, y, Trend::linear, {VectorXd::Constant(3, 0.4), 0.0});
  EXPECT_LT((process.mean(design) - y).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(process.mean_variance(design).maxCoeff(), 1e-8 * process.variance());
  EXPECT_EQ(process.noise(), 0.0);
}

TEST(GaussianProcess, OnlyItsExactRunsAreMetWhereTheOthersHaveNoise) {
  const MatrixXd design = column({0.1, 0.3, 0.5, 0.7, 0.9, 0.0, 1.0});
  VectorXd y(7);
  y << 0.2, -0.1, 0.3, 0.0, -0.2, 0.0, 1.0;
  const GaussianProcess process(design, y, Trend::constant, {VectorXd::Constant(1, 0.5), 1.0}, 2);
  EXPECT_EQ(process.runs(), 5);
  const VectorXd off = (process.mean(design) - y).cwiseAbs();
  EXPECT_LT(off.tail(2).maxCoeff(), 1e-8);
  EXPECT_GT(off.head(5).minCoeff(), 1e-3);
  EXPECT_EQ(process.left_out_errors().size(), 5);
}

TEST(GaussianProcess, ReproducesItsTrend) {
  const MatrixXd design = hypercube(4, 40, 2), points = hypercube(4, 50, 9);
  const Function polynomial = [](const RowVectorXd& u) {
    return 2.0 - u(0) + 3.0 * u(1) * u(2) + 0.5 * u(3) * u(3);
  };
  const GaussianProcess process = GaussianProcess::fit(design, values(polynomial, design), Trend::quadratic);
  EXPECT_LT((process.mean(points) - values(polynomial, points)).cwiseAbs().maxCoeff(), 1e-6);
}

// A choice has no square: with it the trend would have the same column twice.
TEST(GaussianProcess, TakesAChoice) {
  MatrixXd design = hypercube(2, 30, 6);
  design.col(1) = (design.col(1).array() < 0.5).select(VectorXd::Zero(30), VectorXd::Ones(30));
  const Function function = [](const RowVectorXd& u) { return std::exp(u(0)) + u(1) * u(0); };
  const GaussianProcess process = GaussianProcess::fit(design, values(function, design), Trend::quadratic);
  MatrixXd points(2, 2);
  points << 0.4, 0.0, 0.4, 1.0;
  EXPECT_NEAR(process.mean(points)(0), std::exp(0.4), 1e-3);
  EXPECT_NEAR(process.mean(points)(1), std::exp(0.4) + 0.4, 1e-3);
}

TEST(GaussianProcess, FindsLengthsAndNoise) {
  const MatrixXd design = hypercube(2, 80, 11);
  VectorXd y = values([](const RowVectorXd& u) { return std::sin(9.0 * u(0)) + 0.3 * u(1); }, design);
  for (Index i = 0; i < y.size(); ++i) y(i) += i % 2 == 0 ? 0.05 : -0.05;  // noise of variance 0.0025
  const GaussianProcess process = GaussianProcess::fit(design, y, Trend::linear);
  EXPECT_LT(process.kernel().lengths(0), 0.5);
  EXPECT_GT(process.kernel().lengths(1), 1.0);
  EXPECT_NEAR(process.noise(), 0.0025, 0.0010);
}

TEST(GaussianProcess, GivesTheSameBitsAgain) {
  const MatrixXd design = hypercube(3, 30, 1), points = hypercube(3, 5, 2);
  const VectorXd y = values(ishigami, design);
  const GaussianProcess a = GaussianProcess::fit(design, y, Trend::linear),
                        b = GaussianProcess::fit(design, y, Trend::linear);
  EXPECT_EQ(a.mean(points), b.mean(points));
  EXPECT_EQ(a.mean_variance(points), b.mean_variance(points));
  // From its parts, as they are stored.
  const GaussianProcess c(a.design(), a.values(), a.trend(), a.kernel());
  EXPECT_EQ(a.mean(points), c.mean(points));
}

TEST(GaussianProcess, RefusesWhatCannotBe) {
  const MatrixXd design = hypercube(2, 10, 1);
  const VectorXd y = VectorXd::LinSpaced(10, 0.0, 1.0);
  const Kernel kernel{VectorXd::Constant(2, 0.5), 0.0};
  EXPECT_THROW(GaussianProcess(design, y.head(9), Trend::linear, kernel), std::invalid_argument);
  EXPECT_THROW(GaussianProcess(design, y, Trend::linear, {VectorXd::Constant(1, 0.5), 0.0}),
               std::invalid_argument);
  EXPECT_THROW(GaussianProcess(design, y, Trend::linear, {VectorXd::Constant(2, -0.5), 0.0}),
               std::invalid_argument);
  EXPECT_THROW(GaussianProcess(design, y, Trend::linear, {kernel.lengths, -1.0}), std::invalid_argument);
  MatrixXd flat = design;
  flat.col(1).setConstant(0.5);
  EXPECT_THROW(GaussianProcess(flat, y, Trend::linear, kernel), std::invalid_argument);
  EXPECT_THROW((void)GaussianProcess::fit(flat, y, Trend::linear), std::invalid_argument);
  VectorXd gap = y;
  gap(3) = std::nan("");
  EXPECT_THROW(GaussianProcess(design, gap, Trend::linear, kernel), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::results

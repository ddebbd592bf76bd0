#include "results/emulator/output_emulator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "results/emulator/validation.hpp"
#include "tests/results/emulator/test_functions.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

// Curves over 40 depths: two shapes, whose scores depend on three inputs.
MatrixXd curves(const MatrixXd& points) {
  const VectorXd depth = VectorXd::LinSpaced(40, 0.0, 1.0);
  MatrixXd made(40, points.rows());
  for (Index i = 0; i < points.rows(); ++i) {
    const RowVectorXd u = points.row(i);
    made.col(i) = (3.0 + std::sin(3.0 * u(0)) + u(1) * u(1)) * depth.array().sqrt() +
                  0.5 * u(2) * (6.0 * depth.array()).sin() + 1.0;
  }
  return made;
}

TEST(PrincipalComponents, AreTheShapesThatCurvesAreMadeOf) {
  const MatrixXd made = curves(hypercube(3, 30, 1));
  const PrincipalComponents found = principal_components(made, 1e-12, 8);
  EXPECT_EQ(found.shapes.cols(), 2);
  EXPECT_LT((found.shapes.transpose() * found.shapes - MatrixXd::Identity(2, 2)).norm(), 1e-12);
  const MatrixXd again = (found.shapes * scores(found, made)).colwise() + found.mean;
  EXPECT_LT((again - made).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_LT(found.left_out.maxCoeff(), 1e-20);
  EXPECT_GT(found.shapes.col(0).maxCoeff(), -found.shapes.col(0).minCoeff());
}

TEST(PrincipalComponents, TellWhatTheyLeaveOut) {
  const MatrixXd made = curves(hypercube(3, 30, 1));
  const PrincipalComponents one = principal_components(made, 0.0, 1);
  EXPECT_EQ(one.shapes.cols(), 1);
  const MatrixXd rest = made - ((one.shapes * scores(one, made)).colwise() + one.mean);
  EXPECT_NEAR(one.left_out.sum(), rest.squaredNorm() / 30.0, 1e-12);
  EXPECT_EQ(principal_components(MatrixXd::Constant(5, 4, 2.0), 1e-4, 8).shapes.cols(), 0);
}

TEST(PrincipalComponents, TellHowWhatTheyLeaveOutGoesWithDepth) {
  // One shape, and beside it at each value the mean of three neighbours of white noise: correlations 2/3, 1/3
  // and nothing beyond.
  constexpr Index values = 200, runs = 300;
  std::mt19937 draw(7);
  std::normal_distribution<double> normal(0.0, std::sqrt(3.0));
  MatrixXd noise(values + 3, runs);
  for (double& value : noise.reshaped()) value = normal(draw);
  MatrixXd made = MatrixXd::Ones(values, 1) * (100.0 * noise.bottomRows(1));
  for (Index k = 0; k < 3; ++k) made += noise.middleRows(k, values) / 3.0;
  const PrincipalComponents found = principal_components(made, 0.0, 1);
  EXPECT_NEAR(found.left_out.mean(), 1.0, 0.05);
  EXPECT_DOUBLE_EQ(found.left_out_correlation(0), 1.0);
  EXPECT_NEAR(found.left_out_correlation(1), 2.0 / 3.0, 0.02);
  EXPECT_NEAR(found.left_out_correlation(2), 1.0 / 3.0, 0.02);
  EXPECT_NEAR(found.left_out_correlation(10), 0.0, 0.02);
  const MatrixXd covariance = left_out_covariance(found);
  EXPECT_DOUBLE_EQ(covariance(7, 7), found.left_out(7));
  EXPECT_NEAR(covariance(7, 8), 2.0 / 3.0, 0.1);
  EXPECT_GE(Eigen::SelfAdjointEigenSolver<MatrixXd>(covariance).eigenvalues().minCoeff(), -1e-12);
}

TEST(OutputEmulator, PredictsANumber) {
  const MatrixXd design = hypercube(8, 100, 1), points = hypercube(8, 400, 2);
  const MatrixXd y = values(borehole, design).transpose();
  const OutputEmulator emulator = OutputEmulator::fit(design, y);
  const Validation at = validation_at(emulator, points, values(borehole, points).transpose());
  EXPECT_GT(at.q2, 0.999);
  EXPECT_GT(at.coverage, 0.90);
  // The flow has no sign and spans a decade: its logarithm does better, and that is seen without the points.
  EXPECT_TRUE(emulator.logarithmic());
  EXPECT_GT(
      at.q2,
      validation_at(OutputEmulator::fit(design, y, false), points, values(borehole, points).transpose()).q2);
}

TEST(OutputEmulator, PredictsCurves) {
  const MatrixXd design = hypercube(3, 40, 1), points = hypercube(3, 100, 2);
  const OutputEmulator emulator = OutputEmulator::fit(design, curves(design));
  const OutputPrediction at = emulator.predict(points);
  EXPECT_EQ(at.value.rows(), 40);
  EXPECT_EQ(at.value.cols(), 100);
  EXPECT_LT((at.value - curves(points)).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_TRUE((at.lower.array() <= at.value.array()).all() && (at.value.array() <= at.upper.array()).all());
}

// The interval's half width is 1.96 standard errors; of a logarithm the value is the lognormal mean.
TEST(OutputEmulator, GivesErrorsAndIntervalsThatFitTogether) {
  const MatrixXd design = hypercube(2, 30, 1), point = MatrixXd::Constant(1, 2, 0.43);
  MatrixXd y = (values([](const RowVectorXd& u) { return 2.0 + u(0) + u(1); }, design)).transpose();
  for (Index i = 0; i < 30; ++i) y(i) += i % 3 == 0 ? 0.2 : -0.1;
  const OutputPrediction plain = OutputEmulator::fit(design, y, false).predict(point);
  EXPECT_NEAR(plain.upper(0) - plain.lower(0), 2.0 * normal_95 * plain.error(0), 1e-12);
  const OutputPrediction log = OutputEmulator::fit(design, y, true).predict(point);
  const double mean = 0.5 * (std::log(log.upper(0)) + std::log(log.lower(0)));
  const double deviation = (std::log(log.upper(0)) - std::log(log.lower(0))) / (2.0 * normal_95);
  EXPECT_NEAR(log.value(0), std::exp(mean + 0.5 * deviation * deviation), 1e-9);
  EXPECT_NEAR(log.error(0), log.value(0) * std::sqrt(std::expm1(deviation * deviation)), 1e-9);
  EXPECT_GT(plain.error(0), 0.1);  // the runs scatter by 0.14
}

TEST(OutputEmulator, RefusesWhatCannotBe) {
  const MatrixXd design = hypercube(2, 20, 1);
  const MatrixXd y = values([](const RowVectorXd& u) { return u(0) - 0.5; }, design).transpose();
  EXPECT_THROW((void)OutputEmulator::fit(design, MatrixXd::Constant(1, 20, 3.0)), std::invalid_argument);
  EXPECT_THROW((void)OutputEmulator::fit(design, y, true), std::invalid_argument);
  EXPECT_THROW((void)OutputEmulator::fit(design, y.leftCols(19)), std::invalid_argument);
  EXPECT_THROW((void)OutputEmulator::fit(design, y).predict(MatrixXd::Zero(1, 3)), std::invalid_argument);
  EXPECT_FALSE(OutputEmulator::fit(design, y).logarithmic());  // it has negative values
}

TEST(Validation, CountsAndWilson) {
  // Agresti & Coull (1998), The American Statistician 52, 119: none of 10, 0 to 0.278; 5 of 10, 0.237 to
  // 0.763.
  EXPECT_NEAR(wilson(0.0, 10).upper, 0.2775, 1e-4);
  EXPECT_EQ(wilson(0.0, 10).lower, 0.0);
  EXPECT_NEAR(wilson(0.5, 10).lower, 0.2366, 1e-4);
  EXPECT_NEAR(wilson(0.5, 10).upper, 0.7634, 1e-4);
  MatrixXd y(1, 4), predicted(1, 4);
  y << 1.0, 2.0, 3.0, 4.0;
  predicted << 1.0, 2.0, 3.0, 3.0;
  EXPECT_DOUBLE_EQ(predictivity(y, predicted), 1.0 - 1.0 / 5.0);
  EXPECT_DOUBLE_EQ(predictivity(y, MatrixXd::Constant(1, 4, 2.5)), 0.0);
}

// Runs of a smooth function with a scatter of their own, from a linear congruence.
MatrixXd scattered(const MatrixXd& points, std::uint64_t seed) {
  MatrixXd y =
      values([](const RowVectorXd& u) { return std::sin(4.0 * u(0)) + u(1) * u(2); }, points).transpose();
  for (Index i = 0; i < y.size(); ++i) {
    double sum = -6.0;  // of twelve uniform numbers: nearly normal
    for (int k = 0; k < 12; ++k) {
      seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
      sum += static_cast<double>(seed >> 11U) * 0x1p-53;
    }
    y(i) += 0.1 * sum;
  }
  return y;
}

// Held-out runs tell what fresh ones do.
TEST(Validation, ByFoldsIsNearThatAtFreshRuns) {
  const MatrixXd design = hypercube(3, 80, 1), points = hypercube(3, 1000, 2);
  const MatrixXd y = scattered(design, 5);
  const Validation folds = cross_validation(design, y, false);
  const Validation fresh = validation_at(OutputEmulator::fit(design, y, false), points, scattered(points, 6));
  EXPECT_EQ(folds.runs, 80);
  EXPECT_NEAR(folds.q2, fresh.q2, 0.03);
  EXPECT_NEAR(folds.rmse, fresh.rmse, 0.2 * fresh.rmse);
  // The noise is estimated from 80 runs: of ten times such runs the intervals cover what they say.
  double coverage = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    coverage += validation_at(OutputEmulator::fit(design, scattered(design, 100 + seed), false), points,
                              scattered(points, 200 + seed))
                    .coverage /
                10.0;
  EXPECT_NEAR(coverage, 0.95, 0.03);
  EXPECT_LT(folds.coverage_lower, 0.95);
  EXPECT_GT(folds.coverage_upper, 0.95);
  EXPECT_FALSE(folds.refused());
}

TEST(Validation, RefusesNoise) {
  const MatrixXd design = hypercube(3, 60, 1);
  MatrixXd y(1, 60);
  for (Index i = 0; i < 60; ++i) y(i) = std::sin(1000.0 * static_cast<double>(i * i));
  const Validation folds = cross_validation(design, y, false);
  EXPECT_LT(folds.q2, 0.3);
  EXPECT_TRUE(folds.refused());
}

}  // namespace
}  // namespace cpt::results

#include "diagnosis/calibration/calibration_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/calibration/calibrate.hpp"
#include "diagnosis/covariance.hpp"
#include "tests/diagnosis/calibration/linear_problem.hpp"

namespace cpt::diagnosis {
namespace {

TEST(CalibrationModel, LikelihoodIsThatOfTheWholeCovariance) {
  CalibrationProblem problem = linear_problem(0.05, 0.02);
  CalibrationChannel& channel = problem.channels.front();
  // Two soundings of the same soil: the emulator is off by the same in both.
  problem.soundings.emplace_back("second");
  for (Index i = 12; i < 20; ++i) channel.cells[static_cast<std::size_t>(i)].sounding = 1;
  channel.recorded = linear_recording(problem, 0.5, -1.0, 7);
  const CalibrationModel model(problem);
  ASSERT_EQ(model.unknowns(), 4);
  EXPECT_EQ(model.names()[3], "discrepancy q_c second");
  const VectorXd values = Eigen::Vector4d(0.3, -0.7, 0.04, 0.08);
  const ScorePrediction scores = channel.scores(values.head(2).transpose());
  MatrixXd covariance = channel.shapes * scores.variance.asDiagonal() * channel.shapes.transpose();
  covariance.diagonal().array() += 1e-5 + 0.02 * 0.02;
  std::vector<Cell> first(channel.cells.begin(), channel.cells.begin() + 12);
  std::vector<Cell> second(channel.cells.begin() + 12, channel.cells.end());
  covariance.topLeftCorner(12, 12) += noise_covariance(first, {Kernel::matern_32, 0.04, 0.1});
  covariance.bottomRightCorner(8, 8) += noise_covariance(second, {Kernel::matern_32, 0.08, 0.1});
  const double whole =
      Whitener(covariance).log_density(channel.recorded - channel.mean - channel.shapes * scores.mean);
  EXPECT_NEAR(model.log_likelihood(values), whole, 1e-9 * std::abs(whole));
}

// Without discrepancy everything is normal: the posterior is known.
TEST(CalibrationModel, PosteriorOfALinearEmulatorIsTheKnownNormal) {
  CalibrationProblem problem = linear_problem(1e-9, 0.05);
  CalibrationChannel& channel = problem.channels.front();
  channel.recorded = linear_recording(problem, 1.0, -0.5, 3);
  const MatrixXd slope = channel.shapes * linear_effects;
  MatrixXd covariance = linear_variance * channel.shapes * channel.shapes.transpose();
  covariance.diagonal().array() += 1e-5 + 0.05 * 0.05;
  const MatrixXd weight = covariance.inverse();
  const MatrixXd known = (problem.correlation.inverse() + slope.transpose() * weight * slope).inverse();
  const VectorXd mean = known * (slope.transpose() * weight * (channel.recorded - channel.mean));

  CalibrateOptions options;
  options.sampler.least_size = 1500.0;
  const Posterior found = calibrate(CalibrationModel(problem), options);
  ASSERT_TRUE(found.sample.converged);
  for (Index j = 0; j < 2; ++j) {
    const CalibratedUnknown& unknown = found.unknowns[static_cast<std::size_t>(j)];
    const double width = std::sqrt(known(j, j)), size = unknown.convergence.bulk_size;
    EXPECT_NEAR(unknown.posterior.mean, mean(j), 4.0 * width / std::sqrt(size)) << j;
    EXPECT_NEAR(unknown.posterior.deviation / width, 1.0, 4.0 / std::sqrt(2.0 * size)) << j;
    EXPECT_NEAR(unknown.prior.deviation, 1.0, 0.05);
  }
  const double pearson = known(0, 1) / std::sqrt(known(0, 0) * known(1, 1));
  EXPECT_NEAR(found.correlation(0, 1), 6.0 / std::acos(-1.0) * std::asin(pearson / 2.0), 0.1);
}

TEST(CalibrationModel, DiscrepancyIsFoundWhereItIs) {
  CalibrationProblem problem = linear_problem(0.1, 0.005);
  CalibrationChannel& channel = problem.channels.front();
  channel.length = 0.03;
  channel.recorded = linear_recording(problem, 0.0, 0.0, 5);
  for (Index i = 0; i < 20; ++i)  // 10 % more around cell 10
    channel.recorded(i) += 0.1 * std::exp(-0.5 * std::pow((static_cast<double>(i) - 10.0) / 2.0, 2));
  const Posterior found = calibrate(CalibrationModel(problem), {});
  EXPECT_TRUE(found.sample.converged);
  const std::vector<CalibratedBand>& bands = found.bands.front();
  ASSERT_EQ(bands.size(), 20U);
  EXPECT_TRUE(bands[10].apart());
  EXPECT_NEAR(bands[10].discrepancy.mean, 10.5, 3.0);
  for (const CalibratedBand& band : bands) {
    EXPECT_LE(band.predicted.lower, band.simulation.lower);
    EXPECT_GE(band.predicted.upper, band.simulation.upper);
    EXPECT_GT(band.recorded, band.predicted.lower * 0.9);
  }
  EXPECT_NEAR(bands[10].recorded, std::exp(channel.recorded(10)), 1e-9);
}

TEST(CalibrationModel, UnknownNoiseIsFound) {
  CalibrationProblem problem = linear_problem(1e-9, 0.04);
  problem.channels.front().recorded = linear_recording(problem, 0.0, 0.0, 11);
  problem.channels.front().noise_is_known = false;
  const Posterior found = calibrate(CalibrationModel(problem), {});
  ASSERT_EQ(found.unknowns.back().name, "noise q_c");
  EXPECT_NEAR(found.unknowns.back().posterior.mean, 4.0, 2.0);
  EXPECT_LT(found.unknowns.back().left(), 0.7);
}

TEST(CalibrationModel, HalfNormalHasItsQuantiles) {
  EXPECT_NEAR(half_normal_value(2.0, 0.0), 2.0 * 0.6744897501960817, 1e-12);  // median
  EXPECT_NEAR(half_normal_value(1.0, 1.6448536269514722), 1.959963984540054, 1e-9);
  EXPECT_GE(half_normal_value(1.0, -40.0), 0.0);
  EXPECT_TRUE(std::isfinite(half_normal_value(1.0, 40.0)));
}

TEST(CalibrationModel, StaysWithinWhatTheEmulatorKnows) {
  CalibrationProblem problem = linear_problem(0.05, 0.02);
  problem.inputs[0].lower = -0.5;
  problem.inputs[0].upper = 0.5;
  const CalibrationModel model(problem);
  EXPECT_EQ(model.log_posterior(Eigen::Vector3d(0.6, 0.0, 0.0)), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isfinite(model.log_posterior(Eigen::Vector3d(0.4, 0.0, 0.0))));
  Random random(1, 1);
  for (int k = 0; k < 100; ++k) EXPECT_LE(std::abs(model.draw_prior(random)(0)), 0.5);
}

}  // namespace
}  // namespace cpt::diagnosis

#include <gtest/gtest.h>

#include <boost/math/distributions/beta.hpp>
#include <chrono>

#include "diagnosis/departure.hpp"
#include "diagnosis/parameters_prior.hpp"
#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

double overlap(const Mismatch& found, double from, double to) {
  const double shared = std::min(found.to, to) - std::max(found.from, from);
  return std::max(shared, 0.0) / (std::max(found.to, to) - std::min(found.from, from));
}

TEST(Locate, GivesTheStepsLikelihoodRatio) {
  const auto cells = toy::cells(2, 20);
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  VectorXd step = VectorXd::Zero(40);
  step.segment(5, 4).setConstant(1.0);
  step.segment(25, 4).setConstant(1.0);
  const Step found = StepScan(cells, M, 1).best(M.solve(0.3 * step));
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_EQ(found.rows[1].first, 25);
  EXPECT_EQ(found.rows[1].end, 29);
  EXPECT_NEAR(found.size, 0.3, 1e-9);
  EXPECT_NEAR(found.statistic, 0.09 * M.whiten(step).squaredNorm(), 1e-6);
}

TEST(Locate, RaisesAsManyFalseAlarmsAsPromised) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const MatrixXd calibration = draw_null(null, 1000, 1), cases = draw_null(null, 300, 2);
  const Whitener M(null.covariance);
  // The same with the noise's deviation right but its correlation left out.
  const NullModel iid = null_model(null.parameters, MatrixXd(null.sigma.diagonal().asDiagonal()));
  const Whitener iid_M(iid.covariance);
  const MatrixXd iid_calibration = draw_null(iid, 1000, 1);

  int alarms = 0, iid_alarms = 0;
  const StepScan scan(cells, M, 2), iid_scan(cells, iid_M, 2);
  const VectorXd draws = scan.greatest(M.solve(calibration)), seen = scan.greatest(M.solve(cases));
  const VectorXd iid_draws = iid_scan.greatest(iid_M.solve(iid_calibration));
  const VectorXd iid_seen = iid_scan.greatest(iid_M.solve(cases));
  for (Index k = 0; k < 300; ++k) {
    if (bootstrap_p(seen(k), draws) <= 0.05) ++alarms;
    if (bootstrap_p(iid_seen(k), iid_draws) <= 0.05) ++iid_alarms;
  }
  const boost::math::beta_distribution<> low(alarms, 301.0 - alarms), high(alarms + 1.0, 300.0 - alarms);
  EXPECT_LT(quantile(low, 0.025), 0.05) << alarms;
  EXPECT_GT(quantile(high, 0.975), 0.05) << alarms;
  EXPECT_GT(iid_alarms, 150);
  RecordProperty("alarms_of_300", alarms);
  RecordProperty("iid_alarms_of_300", iid_alarms);
}

TEST(Locate, FindsStepsOfEitherSign) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  const MatrixXd draws = draw_null(null, 1000, 1);
  VectorXd residual = draw_null(null, 1, 77);
  residual.segment(10, 12).array() += 0.25;
  residual.segment(40, 10).array() -= 0.25;
  const Location location = locate(cells, residual, M, draws, null.mean);
  ASSERT_GE(location.mismatches.size(), 2U);
  EXPECT_GT(location.greatest, location.threshold);
  EXPECT_LE(location.p, 0.002);
  for (int k = 0; k < 2; ++k) {
    const Mismatch& found = location.mismatches[static_cast<std::size_t>(k)];
    const bool upper = found.size > 0.0;
    EXPECT_GT(upper ? overlap(found, 0.1, 0.22) : overlap(found, 0.4, 0.5), 0.7);
    EXPECT_NEAR(std::abs(found.size), 0.25, 0.08);
    const Departure seen = departure_on(cells, null.mean + residual, null.mean, found);
    EXPECT_EQ(seen.percent > 0.0, upper);
    EXPECT_NEAR(seen.difference / (upper ? 2.8e6 : 4.25e6), 0.01 * seen.percent, 0.1);
  }
}

TEST(Locate, ADepartureIsTheMeanOfRecordedOverRefitted) {
  const std::vector<Cell> cells = cells_of({{0.0, 0.01, 4}, {0.0, 0.01, 4}});
  VectorXd refitted = VectorXd::Constant(8, std::log(1e6)), recorded = refitted;
  recorded(1) += std::log(1.5);
  recorded(2) += std::log(0.9);
  recorded(5) += std::log(0.6);
  const Departure one =
      departure_on(cells, recorded, refitted, {0, 0.01, 0.03, -0.4, -33.0, -3e5, 20.0, 0.001});
  EXPECT_NEAR(one.percent, 20.0, 1e-9);
  EXPECT_NEAR(one.least, -10.0, 1e-9);
  EXPECT_NEAR(one.greatest, 50.0, 1e-9);
  EXPECT_NEAR(one.difference, 2e5, 1e-3);
  const Departure all =
      departure_on(cells, recorded, refitted, {-1, 0.01, 0.03, 0.4, 49.0, 5e5, 20.0, 0.001});
  EXPECT_NEAR(all.percent, 0.0, 1e-9);
  EXPECT_TRUE(std::isnan(
      departure_on(cells, recorded, refitted, {0, 0.5, 0.6, 0.4, 49.0, 5e5, 20.0, 0.001}).percent));
}

TEST(Locate, LeavesToTheParametersWhatTheyExplain) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const VectorXd scaled = null.parameters.predict(Eigen::Vector2d(0.95, 0.9)) - null.mean;
  const Location location =
      locate(cells, scaled, Whitener(null.covariance), draw_null(null, 1000, 1), null.mean);
  EXPECT_TRUE(location.mismatches.empty());
  EXPECT_GT(location.p, 0.5);
}

TEST(Locate, IsFastAndRepeatsItself) {
  const auto cells = toy::cells(2, 100);
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  VectorXd residual = draw_null(null, 1, 9);
  residual.segment(30, 20).array() += 0.2;
  residual.segment(130, 20).array() += 0.2;
  const auto start = std::chrono::steady_clock::now();
  const Location a = locate(cells, residual, M, draw_null(null, 1000, 1), null.mean);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds_of_1000_draws_on_200_cells", std::to_string(seconds.count()));
  const Location b = locate(cells, residual, M, draw_null(null, 1000, 1), null.mean);
  ASSERT_FALSE(a.mismatches.empty());
  EXPECT_EQ(a.mismatches[0].sounding, -1);
  EXPECT_EQ(a.threshold, b.threshold);
  EXPECT_EQ(a.mismatches[0].statistic, b.mismatches[0].statistic);
}

}  // namespace
}  // namespace cpt::diagnosis

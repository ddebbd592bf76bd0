#include "diagnosis/calibration/adaptive_metropolis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd dispersed(Eigen::Index coordinates) {
  Random random(1, 99);
  MatrixXd starts(4, coordinates);
  for (Eigen::Index c = 0; c < 4; ++c) starts.row(c) = 3.0 * random.normals(coordinates).transpose();
  return starts;
}

TEST(AdaptiveMetropolis, DrawsFromACorrelatedNormalOfUnequalWidths) {
  const MatrixXd root = (MatrixXd(3, 3) << 1.0, 0.0, 0.0, 0.9, 0.4, 0.0, 0.0, 0.02, 0.03).finished();
  const MatrixXd covariance = root * root.transpose(), precision = covariance.inverse();
  const VectorXd mean = Eigen::Vector3d(1.0, -2.0, 5.0);
  const LogDensity density = [&](const VectorXd& x) { return -0.5 * (x - mean).dot(precision * (x - mean)); };
  const Sample found = sample(density, dispersed(3));
  ASSERT_TRUE(found.converged);
  const MatrixXd draws = found.thinned(std::numeric_limits<Eigen::Index>::max());
  const VectorXd here = draws.colwise().mean();
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Convergence& told = found.convergence[static_cast<std::size_t>(j)];
    EXPECT_GT(told.least_size(), 400.0);
    const double width = std::sqrt(covariance(j, j));
    EXPECT_NEAR(here(j), mean(j), 4.0 * width / std::sqrt(told.bulk_size)) << j;
    const double spread = std::sqrt((draws.col(j).array() - here(j)).square().mean());
    EXPECT_NEAR(spread / width, 1.0, 4.0 / std::sqrt(2.0 * told.bulk_size)) << j;
  }
  EXPECT_NEAR(found.accepted, 0.234, 0.1);
}

TEST(AdaptiveMetropolis, SameSeedSameBits) {
  const LogDensity density = [](const VectorXd& x) { return -x.cwiseAbs().sum(); };
  SamplerOptions options;
  options.first_round = options.last_round = 500;
  const Sample one = sample(density, dispersed(2), options), two = sample(density, dispersed(2), options);
  EXPECT_TRUE(one.chains == two.chains);
  options.seed = 2;
  EXPECT_FALSE(one.chains == sample(density, dispersed(2), options).chains);
}

TEST(AdaptiveMetropolis, TellsThatChainsSitInTwoPlaces) {
  const LogDensity density = [](const VectorXd& x) {
    const double d = std::min(std::abs(x(0) - 30.0), std::abs(x(0) + 30.0));
    return -0.5 * d * d;
  };
  SamplerOptions options;
  options.last_round = 4000;
  MatrixXd starts(4, 1);
  starts << -30.0, 30.0, -29.0, 31.0;
  const Sample found = sample(density, starts, options);
  EXPECT_FALSE(found.converged);
  EXPECT_GT(found.convergence.front().r_hat, 1.5);
}

TEST(AdaptiveMetropolis, RefusesStartsOfNoDensityAndASingleChain) {
  const LogDensity half = [](const VectorXd& x) {
    return x(0) > 0.0 ? -x(0) : -std::numeric_limits<double>::infinity();
  };
  EXPECT_THROW((void)sample(half, MatrixXd::Constant(4, 1, -1.0)), std::invalid_argument);
  EXPECT_THROW((void)sample(half, MatrixXd::Constant(1, 1, 1.0)), std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

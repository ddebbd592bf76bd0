#include "diagnosis/calibration/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

// Chains x(t) = phi x(t - 1) + sqrt(1 - phi^2) z: their mean's effective size is n (1 - phi) / (1 + phi).
Eigen::MatrixXd autoregressive(double phi, Eigen::Index steps) {
  Eigen::MatrixXd draws(steps, 4);
  for (Eigen::Index c = 0; c < draws.cols(); ++c) {
    Random random(3, static_cast<std::uint64_t>(c));
    double x = random.normal();
    for (Eigen::Index i = 0; i < steps; ++i) {
      x = phi * x + std::sqrt(1.0 - phi * phi) * random.normal();
      draws(i, c) = x;
    }
  }
  return draws;
}

TEST(Convergence, EffectiveSizeOfAutoregressiveChainsIsTheirs) {
  for (const double phi : {-0.3, 0.0, 0.5, 0.9}) {
    const Eigen::MatrixXd draws = autoregressive(phi, 10000);
    const double known = static_cast<double>(draws.size()) * (1.0 - phi) / (1.0 + phi);
    EXPECT_NEAR(effective_size(draws) / known, 1.0, 0.1) << phi;
    const Convergence here = convergence(draws);
    EXPECT_NEAR(here.bulk_size / known, 1.0, 0.1) << phi;  // ranks of normal draws are nearly their values
    EXPECT_LT(here.r_hat, 1.01) << phi;
    EXPECT_GT(here.r_hat, 0.999) << phi;
  }
  EXPECT_NEAR(convergence(autoregressive(0.0, 10000)).tail_size / 40000.0, 1.0, 0.1);
}

TEST(Convergence, ChainsThatDifferInPlaceOrWidthOrDriftAreFound) {
  const Eigen::MatrixXd alike = autoregressive(0.0, 1000);
  Eigen::MatrixXd shifted = alike, wide = alike, drifting = alike;
  shifted.col(0).array() += 1.0;
  wide.col(0) *= 3.0;
  for (Eigen::Index i = 0; i < drifting.rows(); ++i)
    drifting.row(i).array() += 0.001 * static_cast<double>(i);
  EXPECT_LT(convergence(alike).r_hat, 1.01);
  EXPECT_GT(convergence(shifted).r_hat, 1.05);
  EXPECT_GT(convergence(wide).r_hat, 1.05);      // by the distances from the median alone
  EXPECT_GT(convergence(drifting).r_hat, 1.01);  // by the halves
  EXPECT_LT(convergence(shifted).bulk_size, 100.0);
}

TEST(Convergence, RanksOutliveATransform) {
  const Eigen::MatrixXd draws = autoregressive(0.5, 500);
  const Convergence plain = convergence(draws), cubed = convergence(draws.array().cube() + 7.0);
  EXPECT_DOUBLE_EQ(plain.bulk_size, cubed.bulk_size);
  EXPECT_NEAR(plain.tail_size, cubed.tail_size, 1e-9 * plain.tail_size);
}

TEST(Convergence, NothingIsSaidOfConstantsAndOfFewSteps) {
  EXPECT_TRUE(std::isnan(convergence(Eigen::MatrixXd::Ones(100, 4)).r_hat));
  EXPECT_TRUE(std::isnan(convergence(autoregressive(0.0, 7)).bulk_size));
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/curve_emulator.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(CurveEmulator, ReproducesAQuadraticFamily) {
  const auto cells = toy::cells();
  const auto truth = [&](double a, double b) {
    return toy::curve(cells, [&](double z) { return a * (0.3 * z + b * std::sin(5.0 * z)) + a * a * z * z; });
  };
  CurveEmulator::Options all_components;
  all_components.variance_left = 1e-14;
  const CurveEmulator emulator(toy::effect("quadratic", {"a", "b"}, 24, truth), all_components);
  for (const double a : {0.1, 0.47, 0.9})
    for (const double b : {0.05, 0.6})
      EXPECT_LT((emulator.mean(Eigen::Vector2d(a, b)) - truth(a, b)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(emulator.mean(Eigen::Vector2d(0.0, 0.3)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(emulator.left_out_residuals().cwiseAbs().maxCoeff(), 1e-5);
}

TEST(CurveEmulator, ErrsAboutAsMuchAsItClaims) {
  const auto cells = toy::cells();
  const CurveEmulator emulator(toy::lens(cells, 40));
  double error = 0.0, claimed = 0.0;
  Random random(3, 0);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2d phi(random.uniform(), random.uniform());
    const VectorXd missed = emulator.mean(phi) - toy::lens_curve(cells, phi(0), phi(1));
    error += missed.squaredNorm() / 100.0;
    claimed += emulator.covariance(phi).trace() / 100.0;
  }
  EXPECT_LT(error, 3.0 * claimed);
  EXPECT_GT(error, claimed / 5.0);
  EXPECT_LT(std::sqrt(error / 60.0), 0.1 * 0.3);
}

TEST(CurveEmulator, HasNoErrorWithoutStrength) {
  const auto cells = toy::cells();
  const CurveEmulator emulator(toy::lens(cells, 40));
  EXPECT_LT(emulator.mean(Eigen::Vector2d(0.0, 0.5)).norm(), 1e-4);
  EXPECT_LT(emulator.covariance(Eigen::Vector2d(0.0, 0.5)).trace(),
            1e-3 * emulator.covariance(Eigen::Vector2d(0.9, 0.97)).trace());
}

// In other soil the lens acts by half as much or half as much again: that is not in the runs at the baseline.
TEST(CurveEmulator, OtherSoilWidensTheErrorInProportionToTheEffect) {
  const auto cells = toy::cells();
  MechanismEffect effect = toy::lens(cells, 40);
  const CurveEmulator without(effect);
  effect.joint_design = (MatrixXd(3, 2) << 0.5, 0.2, 0.8, 0.5, 0.6, 0.9).finished();
  effect.joint_delta.resize(effect.delta.rows(), 3);
  for (Index k = 0; k < 3; ++k)
    effect.joint_delta.col(k) =
        (k == 1 ? 0.5 : 1.5) * toy::lens_curve(cells, effect.joint_design(k, 0), effect.joint_design(k, 1));
  const CurveEmulator with(effect);
  const Eigen::Vector2d weak(0.3, 0.5), strong(0.6, 0.5);
  EXPECT_EQ(with.mean(strong), without.mean(strong));
  const double gained = with.covariance(strong).trace() - without.covariance(strong).trace();
  EXPECT_GT(gained, 0.2 * 0.25 * with.mean(strong).squaredNorm());
  EXPECT_LT(gained, 5.0 * 0.25 * with.mean(strong).squaredNorm());
  EXPECT_NEAR((with.covariance(weak).trace() - without.covariance(weak).trace()) / gained, 0.25, 0.01);
  effect.joint_delta.resize(3, 3);
  EXPECT_THROW(CurveEmulator{effect}, std::invalid_argument);
}

TEST(CurveEmulator, IsTheSameOnSomeCells) {
  const auto cells = toy::cells();
  const CurveEmulator emulator(toy::lens(cells, 40));
  const std::vector<Index> kept{3, 17, 42};
  const Eigen::Vector2d phi(0.6, 0.4);
  EXPECT_LT((emulator.rows(kept).mean(phi) - VectorXd(emulator.mean(phi)(kept))).norm(), 1e-14);
}

TEST(CurveEmulator, RefusesWhatItCannotFit) {
  const auto cells = toy::cells();
  MechanismEffect effect = toy::lens(cells, 40);
  effect.design(0, 0) = 1.5;
  EXPECT_THROW(CurveEmulator{effect}, std::invalid_argument);
  EXPECT_THROW(CurveEmulator{toy::lens(cells, 7)}, std::invalid_argument);
}

}  // namespace
}  // namespace cpt::diagnosis

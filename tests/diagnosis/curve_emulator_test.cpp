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

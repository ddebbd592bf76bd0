#include "diagnosis/evidence.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "diagnosis/quadrature.hpp"
#include "diagnosis/unknown.hpp"
#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

TEST(Quadrature, IsExactForPolynomialsAndBoxes) {
  const Quadrature line = gauss_legendre(5);
  EXPECT_NEAR(line.weights.dot(line.nodes.col(0).array().pow(9).matrix()), 0.1, 1e-14);
  const Quadrature box = box_rule(Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d(2.0, 4.0), 4);
  EXPECT_NEAR(box.weights.sum(), 1.0, 1e-14);
  EXPECT_NEAR(box.weights.dot(box.nodes.col(0).cwiseProduct(box.nodes.col(1).cwiseAbs2())), 1.5 * 28.0 / 3.0,
              1e-12);
  EXPECT_NEAR(log_sum_exp(Eigen::Vector2d(-1000.0, -1000.0)), -1000.0 + std::log(2.0), 1e-12);
}

// Integral of exp(-(a - centre)^2 / (2 width^2)) over [0, 1].
double bell(double centre, double width) {
  const auto part = [&](double x) { return std::erf((x - centre) / (std::numbers::sqrt2 * width)); };
  return width * std::sqrt(std::numbers::pi / 2.0) * (part(1.0) - part(0.0));
}

TEST(Evidence, OfALinearMechanismIsTheAnalyticOne) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  for (const double size : {0.05, 0.5, 20.0}) {  // down to a peak much narrower than the first grid
    const VectorXd g = toy::curve(cells, [&](double z) { return size * std::sin(9.0 * z); });
    const CurveEmulator emulator(
        toy::effect("linear", {"a"}, 12, [&](double a, double) -> VectorXd { return a * g; }));
    const VectorXd r = draw_null(null, 1, 4).col(0) + 0.6 * g;
    const VectorXd w = M.whiten(g), x = M.whiten(r);
    const double centre = w.dot(x) / w.squaredNorm();
    const double exact = M.log_density(r - centre * g) + std::log(bell(centre, 1.0 / w.norm()));
    const MechanismEvidence found = mechanism_evidence(MechanismLikelihood(emulator, M), r);
    EXPECT_NEAR(found.log_evidence, exact, 1e-3) << size;
    if (size < 0.1) continue;  // the posterior is cut at the cube's faces
    EXPECT_NEAR(found.mean(0), centre, 0.02 / w.norm());
    EXPECT_NEAR(found.deviation(0), 1.0 / w.norm(), 0.02 / w.norm());
    EXPECT_NEAR(found.upper(0) - found.lower(0), 2.0 * 1.645 / w.norm(), 0.1 / w.norm());
    EXPECT_NEAR(found.probability.sum(), 1.0, 1e-12);
  }
}

TEST(Evidence, OfAPairIsTheAnalyticOne) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  const VectorXd g = toy::curve(cells, [](double z) { return 0.3 * std::sin(9.0 * z); });
  VectorXd h = toy::curve(cells, [](double z) { return 0.3 * std::sin(23.0 * z); });
  const VectorXd wg = M.whiten(g);
  h -= g * (wg.dot(VectorXd(M.whiten(h))) / wg.squaredNorm());  // then the integral is a product
  const auto linear = [&](const char* name, const VectorXd& shape) {
    return CurveEmulator(
        toy::effect(name, {"a"}, 12, [&](double a, double) -> VectorXd { return a * shape; }));
  };
  const VectorXd r = draw_null(null, 1, 4).col(0) + 0.6 * g + 0.4 * h;
  const VectorXd wh = M.whiten(h), x = M.whiten(r);
  const double a = wg.dot(x) / wg.squaredNorm(), b = wh.dot(x) / wh.squaredNorm();
  const double exact = M.log_density(r - a * g - b * h) + std::log(bell(a, 1.0 / wg.norm())) +
                       std::log(bell(b, 1.0 / wh.norm()));
  const PairEvidence found = pair_evidence(linear("g", g), linear("h", h), null.covariance, r);
  EXPECT_NEAR(found.log_evidence, exact, 1e-3);
  EXPECT_NEAR(found.first_mode(0), a, 0.05);
  EXPECT_NEAR(found.second_mode(0), b, 0.05);
}

TEST(Evidence, CountsBothModesOfALens) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const CurveEmulator lens(toy::lens(cells, 60));
  const VectorXd r = toy::lens_curve(cells, 0.5, 0.1) + toy::lens_curve(cells, 0.5, 0.9);
  const MechanismEvidence found = mechanism_evidence(MechanismLikelihood(lens, Whitener(null.covariance)), r);
  EXPECT_LT(found.lower(1), 0.3);
  EXPECT_GT(found.upper(1), 0.7);
}

TEST(Evidence, OfTheEmulatorsErrorIsPartOfTheLikelihood) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const CurveEmulator lens(toy::lens(cells, 16));
  const VectorXd r = toy::lens_curve(cells, 0.8, 0.55);
  const Eigen::Vector2d phi(0.8, 0.55);
  const double direct = Whitener(null.covariance + lens.covariance(phi)).log_density(r - lens.mean(phi));
  const MechanismLikelihood likelihood(lens, Whitener(null.covariance));
  EXPECT_NEAR(likelihood.log_density(phi.transpose(), r)(0), direct, 1e-6 * std::abs(direct));
}

TEST(Evidence, MakesProbabilitiesOfOdds) {
  const VectorXd p = probabilities(Eigen::Vector3d(-1000.0, -1000.0 + std::log(3.0), -2000.0),
                                   Eigen::Vector3d(0.5, 0.25, 0.25));
  EXPECT_NEAR(p(0), 0.4, 1e-12);
  EXPECT_NEAR(p(1), 0.6, 1e-12);
}

TEST(Unknown, PrefersTheNullWhenNothingIsMissingAndItselfWhenAWaveIs) {
  const auto cells = toy::cells();
  const NullModel null = toy::null(cells);
  const Whitener M(null.covariance);
  const MatrixXd draws = draw_null(null, 50, 6);
  const VectorXd wave = toy::curve(cells, [](double z) { return 0.15 * std::sin(40.0 * z); });
  int wrong = 0, found = 0;
  for (Index k = 0; k < 50; ++k) {
    const VectorXd r = draws.col(k);
    if (unknown_evidence(cells, null, r) > M.log_density(r)) ++wrong;
    if (unknown_evidence(cells, null, r + wave) > M.log_density(r + wave) + 3.0) ++found;
  }
  EXPECT_LE(wrong, 10);
  EXPECT_GE(found, 45);
  // What the parameters do is not unknown.
  const VectorXd scaled = null.parameters.predict(Eigen::Vector2d(0.9, 0.4)) - null.mean;
  EXPECT_LT(unknown_evidence(cells, null, scaled), M.log_density(scaled));
}

}  // namespace
}  // namespace cpt::diagnosis

#include "diagnosis/isolability.hpp"

#include <gtest/gtest.h>

#include "tests/diagnosis/toy.hpp"

namespace cpt::diagnosis {
namespace {

CurveEmulator linear(const char* name, const VectorXd& shape) {
  return CurveEmulator(toy::effect(name, {"a"}, 12, [&](double a, double) -> VectorXd { return a * shape; }));
}

TEST(Isolability, OfProportionalSignaturesIsNone) {
  const auto cells = toy::cells();
  const VectorXd g = toy::lens_curve(cells, 1.0, 0.5);
  const VectorXd h = toy::lens_curve(cells, 1.0, 0.1);
  const NullModel null = toy::null(cells);
  const Observation push{
      "push", null.covariance, {linear("g", g), linear("twice g", 2.0 * g), linear("h", h)}};
  const std::vector<VectorXd> phi(3, VectorXd::Constant(1, 0.4));
  const auto [D, strength] = isolability(push, phi);
  const double one = Whitener(null.covariance).whiten(g).norm();
  EXPECT_LT(D(0, 1), 0.01 * one);
  EXPECT_NEAR(strength(0), 0.4 * one, 1e-3 * one);
  EXPECT_NEAR(strength(1), 0.8 * one, 1e-3 * one);
  EXPECT_GT(D(0, 2), 0.3 * one);
  EXPECT_EQ(D(1, 1), 0.0);
  const Imitation imitation = imitate({&push}, 0, phi[0], 1);
  EXPECT_NEAR(imitation.phi(0), 0.2, 1e-3);
}

TEST(Isolability, FindsTheMeasurementThatTellsApart) {
  const auto cells = toy::cells();
  const VectorXd g = toy::lens_curve(cells, 1.0, 0.5), h = toy::lens_curve(cells, 1.0, 0.1);
  const MatrixXd M = toy::null(cells).covariance;
  const Observation present{"push", M, {linear("1", g), linear("2", g)}};
  const Observation alike{"same again", M, {linear("1", g), linear("2", g)}};
  const Observation weak{"weak", 25.0 * M, {linear("1", g), linear("2", h)}};
  const Observation strong{"strong", M, {linear("1", g), linear("2", h)}};
  const std::vector<VectorXd> phi(2, VectorXd::Constant(1, 0.5));
  const auto ranked = next_measurements(present, {alike, weak, strong}, {0, 1}, phi);
  EXPECT_EQ(ranked[0].name, "strong");
  EXPECT_EQ(ranked[2].name, "same again");
  EXPECT_GT(ranked[0].least_distance, 2.5);
  EXPECT_LT(ranked[2].least_distance, 0.1);
}

TEST(Isolability, LetsTheParametersHelpTheImitator) {
  const auto cells = toy::cells();
  const CurveEmulator scaling(toy::scaling(cells, 12));
  const NullModel null = toy::null(cells);
  const VectorXd full = VectorXd::Ones(1);
  const Observation free{"with parameters", null.covariance, {scaling}},
      fixed{"without", null.sigma, {scaling}};
  EXPECT_LT(strength({&free}, 0, full), 2.5);
  EXPECT_GT(strength({&fixed}, 0, full), 2.0 * strength({&free}, 0, full));
}

}  // namespace
}  // namespace cpt::diagnosis

#include "results/statistics/discretization_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cpt::results {
namespace {

// f(h) = f_0 + C h^p on three meshes, finest first.
std::array<MeshResult, 3> manufactured(double f_0, double C, double p, std::array<double, 3> h) {
  std::array<MeshResult, 3> meshes{};
  for (std::size_t k = 0; k < 3; ++k) meshes[k] = {h[k], f_0 + C * std::pow(h[k], p)};
  return meshes;
}

TEST(DiscretizationError, FindsOrderAndLimitOfManufacturedData) {
  for (const double p : {0.6, 1.0, 1.53, 2.0})
    for (const double C : {30.0, -4.0})
      for (const std::array<double, 3> h :
           {std::array{0.25, 0.5, 1.0}, std::array{1.0 / 3.0, 0.5, 1.0}, std::array{0.5, 1.0 / 1.5, 1.0}}) {
        const auto meshes = manufactured(250.0, C, p, h);
        const DiscretizationError found = discretization_error(meshes);
        EXPECT_EQ(found.convergence, Convergence::monotone);
        EXPECT_NEAR(found.order, p, 1e-9);
        EXPECT_NEAR(found.extrapolated, 250.0, 1e-8);
        // 1.25 times the true error of the finest mesh.
        EXPECT_NEAR(found.band, 1.25 * std::abs(meshes[0].value - 250.0) / meshes[0].value, 1e-10);
      }
}

// Celik et al. (2008), Table 1, first column: reattachment length over a step.
TEST(DiscretizationError, GivesTheWorkedExampleOfCelikEtAl) {
  const DiscretizationError found =
      discretization_error({{{1.0, 6.063}, {1.5, 5.972}, {1.5 * 1.333, 5.863}}});
  EXPECT_EQ(found.convergence, Convergence::monotone);
  EXPECT_NEAR(found.order, 1.53, 0.01);
  EXPECT_NEAR(found.extrapolated, 6.1685, 1e-3);
  EXPECT_NEAR(found.band, 0.022, 5e-4);
}

TEST(DiscretizationError, AnOrderAboveTheFormalOneIsToldButNotBelieved) {
  const auto meshes = manufactured(250.0, 30.0, 5.0, {0.25, 0.5, 1.0});
  const DiscretizationError found = discretization_error(meshes);
  EXPECT_NEAR(found.order, 5.0, 1e-9);
  const double correction = (meshes[0].value - meshes[1].value) / 3.0;  // r^2 - 1
  EXPECT_NEAR(found.extrapolated, meshes[0].value + correction, 1e-9);
  EXPECT_NEAR(found.band, 1.25 * std::abs(correction) / meshes[0].value, 1e-12);
  // The fine mesh changes next to nothing after a large step.
  EXPECT_EQ(discretization_error({{{0.5, 1.0}, {1.0, 1.0 + 1e-8}, {2.0, 2.0}}}).order, 20.0);
}

TEST(DiscretizationError, OscillationHasNoOrderButARange) {
  for (const double sign : {1.0, -1.0}) {
    const DiscretizationError found =
        discretization_error({{{0.25, 100.0}, {0.5, 100.0 + 4.0 * sign}, {1.0, 100.0 - 6.0 * sign}}});
    EXPECT_EQ(found.convergence, Convergence::oscillatory);
    EXPECT_TRUE(std::isnan(found.order));
    EXPECT_TRUE(std::isnan(found.extrapolated));
    EXPECT_NEAR(found.band, 0.05, 1e-12);
  }
  const DiscretizationError still = discretization_error({{{0.25, 100.0}, {0.5, 100.0}, {1.0, 102.0}}});
  EXPECT_EQ(still.convergence, Convergence::oscillatory);
  EXPECT_NEAR(still.band, 0.01, 1e-12);
}

TEST(DiscretizationError, RoundingHasNoOrder) {
  const DiscretizationError found =
      discretization_error({{{0.25, 815.15}, {0.5, 815.15 + 1e-11}, {1.0, 815.15 + 4e-11}}});
  EXPECT_EQ(found.convergence, Convergence::constant);
  EXPECT_TRUE(std::isnan(found.order));
  EXPECT_TRUE(std::isnan(found.extrapolated));
  EXPECT_EQ(found.band, 0.0);
  // The two finest alone: the order would be made of their last digits.
  const DiscretizationError last =
      discretization_error({{{0.25, 815.15}, {0.5, 815.15 + 1e-11}, {1.0, 830.0}}});
  EXPECT_EQ(last.convergence, Convergence::oscillatory);
  EXPECT_TRUE(std::isnan(last.order));
}

TEST(DiscretizationError, DifferencesThatGrowGiveNoEstimate) {
  // As the logarithm of h, the limit of no order at all: 2 per ln 1.5 = 0.41, then 3.42 per ln 2 = 0.69.
  const std::array<double, 3> h = {1.0 / 3.0, 0.5, 1.0};
  for (const double step : {1.0, 2.0, 3.4}) {
    const DiscretizationError found =
        discretization_error({{{h[0], 100.0}, {h[1], 102.0}, {h[2], 102.0 + step}}});
    EXPECT_EQ(found.convergence, Convergence::diverging) << step;
    EXPECT_TRUE(std::isnan(found.extrapolated));
  }
  EXPECT_EQ(discretization_error({{{h[0], 100.0}, {h[1], 102.0}, {h[2], 105.5}}}).convergence,
            Convergence::monotone);
  const DiscretizationError equal = discretization_error({{{0.25, 100.0}, {0.5, 102.0}, {1.0, 102.0}}});
  EXPECT_EQ(equal.convergence, Convergence::diverging);
  EXPECT_TRUE(std::isnan(equal.band));
  EXPECT_TRUE(std::isnan(equal.order));
}

}  // namespace
}  // namespace cpt::results

// Linear elasticity against Hooke's law.
#include "solver/constitutive/linear_elastic.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/constitutive/specimen.hpp"

namespace cpt::solver {
namespace {

constexpr double E = 1e6, nu = 0.3;

// eps = ((1 + nu) sigma - nu tr(sigma)) / E, component by component.
TEST(LinearElastic, InvertsHookesLaw) {
  const PointStress target = {-3e3, -7e3, 1e3, 2e3};
  const double trace = target.rr + target.zz + target.tt;
  const auto strain = [&](double s, double direct) { return ((1.0 + nu) * s - nu * trace * direct) / E; };
  Specimen specimen(LinearElastic(E, nu), {0.0, 0.0, 0.0, 0.0}, 0.5);
  specimen.strain(strain(target.rr, 1.0), strain(target.zz, 1.0), strain(target.tt, 1.0),
                  strain(target.rz, 0.0));
  EXPECT_NEAR(specimen.stress().rr, target.rr, 1e-9);
  EXPECT_NEAR(specimen.stress().zz, target.zz, 1e-9);
  EXPECT_NEAR(specimen.stress().tt, target.tt, 1e-9);
  EXPECT_NEAR(specimen.stress().rz, target.rz, 1e-9);
}

TEST(LinearElastic, ModulusIsTheOedometricOne) {
  Specimen specimen(LinearElastic(E, nu), {0.0, 0.0, 0.0, 0.0}, 0.5);
  specimen.strain(0.0, -1e-3, 0.0, 0.0);
  const double oedometric = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
  EXPECT_NEAR(specimen.modulus(), oedometric, 1e-12 * oedometric);
  EXPECT_NEAR(specimen.stress().zz, -1e-3 * oedometric, 1e-9);
  EXPECT_NEAR(specimen.stress().rr, -1e-3 * oedometric * nu / (1.0 - nu), 1e-9);
}

TEST(LinearElastic, VoidRatioFollowsTheVolume) {
  Specimen specimen(LinearElastic(E, nu), {0.0, 0.0, 0.0, 0.0}, 0.5);
  for (int i = 0; i < 100; ++i) specimen.strain(1e-4, -3e-4, 5e-5, 1e-4);
  EXPECT_NEAR(specimen.e(), 1.5 * std::exp(-0.015) - 1.0, 1e-14);
}

}  // namespace
}  // namespace cpt::solver

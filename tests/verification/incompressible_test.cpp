// Nearly incompressible elasticity: a cavity that opens slowly in a thick cylinder, against Lame's solution.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/cylinder.hpp"

namespace cpt::solver::test {
namespace {

// Relative error of the radial stress at the cavity of a cylinder with outer radius 5 times the inner, outer
// wall free.
double lame_error(double nu, int cells) {
  const double G = 1e6, a = 0.1, b = 0.5, expansion = 1e-3;
  Cylinder cylinder(a, b, cells, 0.0);
  const double pressure = cylinder.expand(elastic_soil(2.0 * G * (1.0 + nu), nu), a * (1.0 + expansion), 0.4);
  // Plane strain: u(r) = A r + B / r, sigma_r = 2 G (A / (1 - 2 nu) - B / r^2), sigma_r(b) = 0.
  const double ratio = 1.0 / ((1.0 - 2.0 * nu) * -1.0);
  const double reached = 0.975 * expansion;  // in the middle of the averaging time
  const double B = reached * a / (1.0 / a + (1.0 - 2.0 * nu) * a / (b * b));
  const double A = (1.0 - 2.0 * nu) * B / (b * b);
  const double exact = -2.0 * G * (-A * ratio - B / (a * a));
  return pressure / exact - 1.0;
}

TEST(Incompressible, CylinderDoesNotLock) {
  EXPECT_NEAR(lame_error(0.3, 16), 0.0, 0.01);
  EXPECT_NEAR(lame_error(0.4995, 16), 0.0, 0.01);
}

}  // namespace
}  // namespace cpt::solver::test

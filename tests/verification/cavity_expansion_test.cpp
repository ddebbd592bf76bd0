// Cylindrical cavity expansion in Tresca clay through the MPM, against the large-strain undrained closed form
// (Gibson & Anderson 1961), with the elastic outer annulus cut at the finite radius where p_0 is held:
// p - p_0 = s_u [1 + ln(rho^2 / a^2) - rho^2 / b^2], rho^2 = (G / s_u) (a^2 - a_0^2).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/cylinder.hpp"

namespace cpt::solver::test {
namespace {

TEST(CavityExpansion, CylinderInTrescaClay) {
  const TrescaParameters clay;
  const double a_0 = 0.01, b = 0.4, p_0 = 100e3;
  for (const double ratio : {1.3, 2.0}) {
    Cylinder cylinder(a_0, b, 32, p_0);
    cylinder.mass_scaling = 20.0;
    const double pressure = cylinder.expand(TrescaParameters::law().model(clay, {}), ratio * a_0, 0.25);
    const double a = a_0 * (1.0 + (ratio - 1.0) * 0.975);  // middle of the averaging time
    const double rho2 = clay.G / clay.s_u * (a * a - a_0 * a_0);
    const double exact = clay.s_u * (1.0 + std::log(rho2 / (a * a)) - rho2 / (b * b));
    EXPECT_NEAR((pressure - p_0) / exact, 1.0, 0.03) << "a / a_0 = " << ratio << ", exact " << exact << " Pa";
  }
}

}  // namespace
}  // namespace cpt::solver::test

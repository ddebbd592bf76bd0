// Softening, rate dependence and strength profiles of clay against their closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/actual_setup.hpp"
#include "solver/constitutive/varying_tresca.hpp"
#include "solver/quantities.hpp"
#include "tests/solver/default_soils.hpp"
#include "tests/solver/mechanisms/mechanism_fixture.hpp"

namespace cpt::solver {
namespace {

// One batch of clay in pure shear, step by step.
class Shear {
 public:
  Shear(const StrainSoftening& softening, const RateDependence& rate, double s_u)
      : law_(TrescaParameters{}, softening, rate) {
    std::fill_n(fields_[5], batch_width, s_u);
  }
  /// Radial stress less vertical stress over two [Pa] after an increment of shear strain over `dt`.
  double strain(double gamma, double dt) {
    std::fill_n(fields_[6], batch_width, 0.5 * gamma);
    std::fill_n(fields_[7], batch_width, -0.5 * gamma);
    law_.update({batch_width, fields_[0], fields_[1], fields_[2], fields_[3], fields_[4], fields_[5],
                 fields_[6], fields_[7], fields_[8], fields_[9], fields_[10], dt});
    return 0.5 * (fields_[0][0] - fields_[1][0]);
  }
  [[nodiscard]] double xi() const { return fields_[10][0]; }

 private:
  VaryingTresca law_;
  alignas(64) double fields_[11][batch_width] = {};
};

TEST(StrainSoftening, FollowsEinavAndRandolph) {
  Shear shear({0.6, 20.0}, {}, 30e3);
  for (int i = 0; i < 20000; ++i) {
    const double before = shear.xi();
    const double strength = shear.strain(2e-3, 1.0);
    if (before > 0.0) {
      EXPECT_NEAR(strength, 30e3 * (1.0 - 0.6 * (1.0 - std::exp(-3.0 * before / 20.0))), 1e-6 * 30e3);
    }
  }
  // All of the strain but the elastic part became plastic; after 40 = 2 xi_95, 95 % and more is lost.
  EXPECT_NEAR(shear.xi(), 40.0, 0.1);
  EXPECT_NEAR(shear.strain(2e-3, 1.0), 30e3 * 0.4, 0.01 * 30e3);
}

TEST(StrainSoftening, WithoutLossIsTresca) {
  Shear varying({}, {}, 27.9e3);
  double strength = 0.0;
  for (int i = 0; i < 200; ++i) strength = varying.strain(1e-3, 1.0);
  EXPECT_NEAR(strength, 27.9e3, 1e-9 * 27.9e3);
}

TEST(RateDependence, RisesByMuPerDecade) {
  for (const double decades : {1.0, 2.5, 4.0}) {
    Shear shear({}, {0.1, 0.01}, 30e3);
    const double dt = 1e-3, rate = 0.01 * std::pow(10.0, decades);
    double strength = 0.0;
    for (double gamma = 0.0; gamma < 0.3; gamma += rate * dt) strength = shear.strain(rate * dt, dt);
    EXPECT_NEAR(strength, 30e3 * (1.0 + 0.1 * decades), 1e-6 * 30e3);
  }
  Shear slow({}, {0.1, 0.01}, 30e3);  // below the reference rate nothing is lost
  double strength = 0.0;
  for (int i = 0; i < 300; ++i) strength = slow.strain(1e-3, 10.0);
  EXPECT_NEAR(strength, 30e3, 1e-9 * 30e3);
}

// By lambda for each decade, of the profile as of the strength, and the push is that of the other strength.
TEST(PushSpeed, IsAnotherStrength) {
  solver::Setup setup = quick(Profile::homogeneous_clay, 0.03), stronger = setup;
  setup.mechanisms.strength_gradient.gradient = 10e3;
  setup.mechanisms.push_speed = {-1.3, 0.2};
  EXPECT_DOUBLE_EQ(clay_of(actual_setup(setup)).s_u, 0.74 * clay_of(setup).s_u);
  EXPECT_DOUBLE_EQ(actual_setup(setup).mechanisms.strength_gradient.gradient, 7.4e3);
  EXPECT_EQ(canonical_text(actual_setup(actual_setup(setup))), canonical_text(actual_setup(setup)));

  setup.mechanisms.strength_gradient = {};
  setup.mechanisms.push_speed = {1.0, 0.1};
  clay_of(stronger).s_u *= setup.mechanisms.push_speed.factor();
  EXPECT_EQ(run(setup).profile.q_c, run(stronger).profile.q_c);
}

TEST(StrengthProfiles, ArePutOnThePoints) {
  solver::Setup setup = quick(Profile::homogeneous_clay, 0.1);
  setup.mechanisms.strength_gradient.gradient = 12e3;
  setup.mechanisms.clay_crust = {0.5, 0.1};
  const double s_u = clay_of(setup).s_u;
  for_initial_soil(setup, [&](const Point& point, std::int32_t) {
    const double depth = -point.z;
    EXPECT_NEAR(point.h_0, s_u * (1.0 + 0.5 * std::exp(-depth / 0.1)) + 12e3 * depth, 1e-6);
  });
}

// A whole push with constant strength through the varying law is the same push.
TEST(StrengthProfiles, TheVaryingLawPushesLikeTheConstantOne) {
  const solver::Setup setup = quick(Profile::homogeneous_clay, 0.05);
  solver::Setup varying = setup;
  varying.mechanisms.strength_gradient.gradient = 1e-9;
  const double a = mean_q_c(run(setup), 0.03, 0.05), b = mean_q_c(run(varying), 0.03, 0.05);
  EXPECT_NEAR(a, b, 1e-3 * a);
}

}  // namespace
}  // namespace cpt::solver

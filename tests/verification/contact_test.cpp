// The contact law of one node against hand values.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/penetrometer.hpp"

namespace cpt::solver {
namespace {

constexpr double m = 2.0, dt = 1e-3, speed = 0.04;

TEST(Contact, SeparatingNodeIsFree) {
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.5, 1e4}, m, 0.1, 0.3, speed, dt);
  EXPECT_EQ(c.v_r, 0.1);
  EXPECT_EQ(c.v_z, 0.3);
  EXPECT_EQ(c.J_r, 0.0);
  EXPECT_EQ(c.J_z, 0.0);
}

TEST(Contact, SmoothNodeKeepsItsTangentialVelocity) {
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.0, 0.0}, m, -0.1, 0.3, speed, dt);
  EXPECT_DOUBLE_EQ(c.v_r, 0.0);
  EXPECT_DOUBLE_EQ(c.v_z, 0.3);
  EXPECT_DOUBLE_EQ(c.J_r, m * 0.1);
  EXPECT_DOUBLE_EQ(c.J_z, 0.0);
}

TEST(Contact, SlipLosesTheCoulombLimit) {
  // Normal impulse 2 * 0.1 = 0.2, limit 0.25 * 0.2 = 0.05; sliding 0.34 m/s upward relative to the body.
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.25, 0.0}, m, -0.1, 0.3, speed, dt);
  EXPECT_NEAR(c.J_z, -0.05, 1e-15);
  EXPECT_NEAR(c.v_z, 0.3 - 0.05 / m, 1e-15);
  EXPECT_NEAR(c.dissipation, 0.05 * (0.34 - 0.05 / m), 1e-15);
}

TEST(Contact, StickMovesWithTheBody) {
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.5, 0.0}, m, -0.1, -0.02, speed, dt);
  EXPECT_DOUBLE_EQ(c.v_r, 0.0);
  EXPECT_DOUBLE_EQ(c.v_z, -speed);
  EXPECT_NEAR(c.dissipation, 0.0, 1e-18);
}

TEST(Contact, AdhesionActsOnTheTributaryArea) {
  // Limit 14 kPa * 0.01 m2 * 1 ms = 0.14 N s.
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.0, 14e3}, m, -1e-6, 0.3, speed, dt);
  EXPECT_NEAR(c.J_z, -0.14, 1e-12);
}

TEST(Contact, AdhesionNeedsContact) {
  const ContactImpulse c = resolve_contact({1.0, 0.0, 0.01, 0.0, 14e3}, m, 1e-6, 0.3, speed, dt);
  EXPECT_EQ(c.J_z, 0.0);
}

TEST(Contact, InclinedFaceSplitsTheImpulse) {
  const double n_r = std::sqrt(0.75), n_z = -0.5;
  const ContactImpulse c = resolve_contact({n_r, n_z, 0.01, 0.0, 0.0}, m, 0.0, 0.0, speed, dt);
  // Soil at rest, body comes down: approach = 0.04 * (-0.5), pushed along the normal.
  EXPECT_NEAR(c.v_r, 0.02 * n_r, 1e-15);
  EXPECT_NEAR(c.v_z, 0.02 * n_z, 1e-15);
  EXPECT_NEAR(c.J_r * n_z - c.J_z * n_r, 0.0, 1e-15);
}

}  // namespace
}  // namespace cpt::solver

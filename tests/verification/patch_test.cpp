// Patch test on sheared, graded quadrilaterals with joined rows: a linear velocity field gives exact strains,
// and a uniform equilibrium stress gives no force at interior nodes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {
namespace {

constexpr double E = 1e6, nu = 0.3;

// Sheared inside r = 0.3 as under a cone, rows joined beyond r = 0.5.
MeshLayout sheared_layout() {
  MeshLayout layout =
      plain_layout({0.0, 0.1, 0.2, 0.3, 0.38, 0.5, 0.7, 1.0}, {0.0, 0.1, 0.2, 0.33, 0.4, 0.5, 0.6});
  for (std::size_t i = 0; i < layout.r.size(); ++i)
    layout.offset[i] = std::min(layout.r[i] - 0.3, 0.0) * std::sqrt(3.0);
  layout.shear = {0.0, 0.1, 0.12, 0.2, 0.25, 0.1, 0.0};
  layout.i_joined = 5;
  return layout;
}

ModelSettings still() {
  ModelSettings s;
  s.gravity = 0.0;
  return s;
}

TEST(PatchTest, LinearVelocityGivesExactStress) {
  const double A = 0.3, B = -0.7, C = 0.4, D = 0.2, dt = 1e-3;  // v_r = A r, v_z = B z + C r + D
  Model model = elastic_model(sheared_layout(), E, nu, 2000.0, still());
  model.compute_nodal_forces();
  model.accelerate(0.0);
  for (std::int32_t n = 0; n < model.mesh().node_count(); ++n) {
    const double r = model.mesh().node_r(n), z = model.mesh().node_z(n);
    drive(model, n, A * r, B * z + C * r + D);
  }
  model.move_points(dt);
  const double lame = E * nu / ((1 + nu) * (1 - 2 * nu)), two_G = E / (1 + nu), tr = 2 * A + B;
  int points = 0;
  for_each_point(model, [&](const PointFields& p, std::int32_t k) {
    EXPECT_NEAR(p.s_rr[k], dt * (lame * tr + two_G * A), 1e-9 * E * dt);
    EXPECT_NEAR(p.s_tt[k], dt * (lame * tr + two_G * A), 1e-9 * E * dt);
    EXPECT_NEAR(p.s_zz[k], dt * (lame * tr + two_G * B), 1e-9 * E * dt);
    EXPECT_NEAR(p.s_rz[k], dt * two_G * C / 2, 1e-9 * E * dt);
    ++points;
  });
  EXPECT_EQ(points, model.points().size());
}

TEST(PatchTest, UniformStressIsInEquilibriumInside) {
  Model model = elastic_model(sheared_layout(), E, nu, 2000.0, still(), 4, [](Point& p) {
    p.s_rr = p.s_tt = -30e3;
    p.s_zz = -80e3;
  });
  model.compute_nodal_forces();
  const Mesh& mesh = model.mesh();
  std::set<std::int32_t> boundary(mesh.bottom_nodes().begin(), mesh.bottom_nodes().end());
  boundary.insert(mesh.wall_nodes().begin(), mesh.wall_nodes().end());
  double largest_boundary = 0.0, largest_inside = 0.0;
  for (std::int32_t n = 0; n < mesh.node_count(); ++n) {
    const bool top = mesh.node_z(n) > mesh.top() - 1e-9;
    const double f = std::hypot(model.nodes().force.r[n], model.nodes().force.z[n]);
    (top || boundary.count(n) ? largest_boundary : largest_inside) =
        std::max(top || boundary.count(n) ? largest_boundary : largest_inside, f);
  }
  EXPECT_GT(largest_boundary, 100.0);  // N/rad: the state is not simply zero
  EXPECT_LT(largest_inside, 1e-9 * largest_boundary);
}

TEST(PatchTest, BoundaryForcesAreTheExactTractions) {
  const double p = 50e3;
  Model model = elastic_model(sheared_layout(), E, nu, 2000.0, still(), 4,
                              [&](Point& point) { point.s_rr = point.s_zz = point.s_tt = -p; });
  model.compute_nodal_forces();
  double wall = 0.0, bottom = 0.0;
  for (const std::int32_t n : model.mesh().wall_nodes()) wall += model.nodes().force.r[n];
  for (const std::int32_t n : model.mesh().bottom_nodes()) bottom += model.nodes().force.z[n];
  EXPECT_NEAR(wall, p * 1.0 * 0.6, 1e-9 * p);  // pressure times radius times height, per radian
  EXPECT_NEAR(bottom, -p * 0.5, 1e-9 * p);     // pressure times R^2 / 2, per radian
}

}  // namespace
}  // namespace cpt::solver::test

// A body in free fall: mass, momentum and shape are kept exactly, on a mesh that moves through it.
#include <gtest/gtest.h>

#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {
namespace {

TEST(FreeFall, KeepsMassMomentumAndShape) {
  ModelSettings settings;
  MeshLayout layout = plain_layout(lines(0.0, 0.4, 4), lines(0.0, 2.0, 20));
  const double top = 1.95, bottom = 1.05, density = 1800.0;
  // Points only in part of the mesh; v_r = 0 and one vertical velocity.
  Mesh mesh(layout);
  std::vector<Point> points;
  for (const Point& p : fill(mesh, 3, density))
    if (p.z > bottom && p.z < top) points.push_back(p);
  for (Point& p : points) p.v_z = 0.3;
  settings.courant = 0.5;
  Model model(mesh, points, std::vector<std::int32_t>(points.size(), 0), one_soil(elastic_soil(1e6, 0.3)),
              settings);

  double mass0 = 0.0;
  for (const Point& p : points) mass0 += p.mass;
  double t = 0.0;
  while (t < 0.2) {
    model.compute_nodal_forces();
    const double dt = model.stable_time_step();
    model.accelerate(dt);
    model.move_points(dt);
    t += dt;
  }
  double mass = 0.0, momentum = 0.0;
  for_each_point(model, [&](const PointFields& p, std::int32_t k) {
    mass += p.mass[k];
    momentum += p.mass[k] * p.v_z[k];
    EXPECT_NEAR(p.v_z[k], 0.3 - 9.81 * t, 1e-10);
    EXPECT_NEAR(p.v_r[k], 0.0, 1e-12);
    EXPECT_NEAR(p.s_zz[k], 0.0, 1e-4);
  });
  EXPECT_DOUBLE_EQ(mass, mass0);
  EXPECT_NEAR(momentum, mass0 * (0.3 - 9.81 * t), 1e-10 * mass0);
}

}  // namespace
}  // namespace cpt::solver::test

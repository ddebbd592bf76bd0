// The largest stable time step: the dispersion of the scheme against the bound in the code, and tiny random
// velocities on the meshes of all presets, which must not grow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/cell_forces.hpp"
#include "solver/initial_state.hpp"
#include "solver/model.hpp"
#include "solver/presets.hpp"
#include "solver/refinement.hpp"
#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {
namespace {

// Largest (w X + (1 - w) Y) (2 Q - P), with P of points that lie evenly.
double largest_share(double w) {
  constexpr double a = 2.0 / 3.0;
  constexpr int fine = 400;
  double largest = 0.0;
  for (int i = 0; i <= fine; ++i)
    for (int j = 0; j <= fine; ++j) {
      const double X = static_cast<double>(i) / fine, Y = static_cast<double>(j) / fine;
      const double P = (1.0 - a * X) * (1.0 - a * Y), Q = P + unfiltered * (1.0 - P);
      largest = std::max(largest, (w * X + (1.0 - w) * Y) * (2.0 * Q - P));
    }
  return largest;
}

TEST(TimeStep, BoundCoversTheDispersionOfTheScheme) {
  for (int k = 0; k <= 20; ++k) {
    const double w = k / 20.0;
    const double bound = std::max(largest_of_one * std::max(w, 1.0 - w), largest_of_both),
                 exact = largest_share(w);
    EXPECT_GE(bound, exact) << w;
    EXPECT_LE(bound, 1.08 * exact) << w;
  }
}

double kinetic_energy(const Model& model) {
  double energy = 0.0;
  for_each_point(model, [&](const PointFields& p, std::int32_t k) {
    energy += p.mass[k] * (p.v_r[k] * p.v_r[k] + p.v_z[k] * p.v_z[k]);
  });
  return energy;
}

// Kinetic energy of tiny random velocities in an elastic body on a mesh at rest after some steps, over that
// at the start. Points hardly move, so nothing but the time integration can feed them.
double growth(const Mesh& mesh, std::vector<Point> points, double courant, int steps, int levels = 0) {
  std::mt19937 generator(1);
  std::normal_distribution<double> random(0.0, 1e-9);
  for (Point& p : points) {
    p.v_r = random(generator);
    p.v_z = random(generator);
    p.s_rr = p.s_zz = p.s_tt = p.s_rz = p.load = 0.0;
  }
  ModelSettings settings;
  settings.gravity = 0.0;
  settings.courant = courant;
  settings.most_level = levels;
  Model model(mesh, points, std::vector<std::int32_t>(points.size(), 0), one_soil(elastic_soil(1e6, 0.49)),
              settings);
  const double start = kinetic_energy(model);
  const auto fix = [&model](std::int32_t n, bool r, bool z) {
    const NodalVector& v = model.nodes().velocity;
    model.set_velocity(n, r ? 0.0 : v.r[n], z ? 0.0 : v.z[n]);
    if (r) model.hold({n, 1.0, 0.0, 0.0, false});
    if (z) model.hold({n, 0.0, 1.0, 0.0, false});
  };
  for (int k = 0; k < steps || !model.levels().all_meet(); ++k) {
    model.compute_nodal_forces();
    const double dt = model.stable_time_step();
    model.accelerate(dt);
    for (const std::int32_t n : mesh.axis_nodes()) fix(n, true, false);
    for (const std::int32_t n : mesh.wall_nodes()) fix(n, true, false);
    for (const std::int32_t n : mesh.bottom_nodes()) fix(n, false, true);
    if (mesh.tip_depth() > 0.0) {
      for (const std::int32_t n : mesh.face_nodes()) fix(n, true, true);
      for (const std::int32_t n : mesh.shaft_nodes()) fix(n, true, false);
    }
    model.move_points(dt);
  }
  return kinetic_energy(model) / start;
}

TEST(TimeStep, NothingGrowsOnTheMeshOfAnyPreset) {
  const double courant = Numerics{}.courant;
  for (const Preset preset : all_presets()) {
    solver::Setup setup = make_setup(Profile::homogeneous_clay, preset);
    for (const double refinement : {1.0, 2.0, 3.0}) {
      if (refinement > 1.0 && preset != Preset::quick) continue;
      setup.numerics.refinement = refinement;
      solver::Setup actual = setup;
      actual.numerics = refined(setup);
      const Mesh mesh(chamber_layout(actual));
      for (const int levels : {0, Numerics{}.step_levels})
        EXPECT_LT(growth(mesh, initial_state(actual, {}).points, courant, 300, levels), 1.0)
            << to_string(preset) << " " << refinement << " " << levels;
    }
  }
}

// Rows that grow by a tenth each: all levels, some of them one cell wide, for many cycles.
TEST(TimeStep, NothingGrowsWhereAllLevelsMeet) {
  std::vector<double> z = {0.0};
  for (double height = 0.002; z.size() < 40; height *= 1.1) z.push_back(z.back() + height);
  const Mesh mesh(plain_layout(lines(0.0, 0.3, 3), z));
  EXPECT_LT(growth(mesh, fill(mesh, 3, 2000.0), Numerics{}.courant, 8000, highest_level), 1.0);
}

// The test above could not fail otherwise, and the bound is not far from the truth.
TEST(TimeStep, GrowsBeyondTheBound) {
  for (const int per_cell : {2, 4}) {
    const Mesh mesh(plain_layout(lines(0.0, 0.2, 8), lines(-0.1, 0.0, 8)));
    const std::vector<Point> points = fill(mesh, per_cell, 2000.0);
    EXPECT_LT(growth(mesh, points, 0.98, 1000), 1.0);
    EXPECT_FALSE(growth(mesh, points, 1.15, 1000) < 1e3);  // or nothing finite
  }
}

}  // namespace
}  // namespace cpt::solver::test

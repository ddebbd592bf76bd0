#include "solver/refinement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solver/actual_setup.hpp"
#include "solver/mesh.hpp"
#include "solver/presets.hpp"
#include "solver/quantities.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {
namespace {

solver::Setup with(double refinement, double point_density = 1.0, Preset preset = Preset::quick) {
  solver::Setup setup = make_setup(Profile::homogeneous_clay, preset);
  setup.numerics.refinement = refinement;
  setup.numerics.point_density = point_density;
  return setup;
}

TEST(Refinement, OfOneChangesNoBit) {
  for (const Preset preset : all_presets()) {
    const solver::Setup setup = with(1.0, 1.0, preset);
    EXPECT_EQ(canonical_text(actual_setup(setup)), canonical_text(setup)) << to_string(preset);
  }
}

TEST(Refinement, IsCarriedOutOnce) {
  const solver::Setup actual = actual_setup(with(2.0, 4.0));
  EXPECT_EQ(actual.numerics.refinement, 1.0);
  EXPECT_EQ(actual.numerics.point_density, 1.0);
  EXPECT_EQ(canonical_text(actual_setup(actual)), canonical_text(actual));
}

// Between the cone and the wall, cells get smaller by the factor alike at every radius and depth.
TEST(Refinement, DividesEveryCell) {
  for (const Preset preset : {Preset::quick, Preset::paper}) {
    const MeshLayout coarse = chamber_layout(actual_setup(with(1.0, 1.0, preset)));
    for (const double r : {0.5, 1.5, 2.0, 3.0}) {
      const MeshLayout fine = chamber_layout(actual_setup(with(r, 1.0, preset)));
      EXPECT_EQ(fine.i_cone, r * coarse.i_cone);
      const auto cells_to = [](const MeshLayout& layout, double radius) {
        const auto above = std::upper_bound(layout.r.begin(), layout.r.end(), radius);
        const auto i = static_cast<double>(above - layout.r.begin()) - 1.0;
        return i + (radius - *(above - 1)) / (*above - *(above - 1));
      };
      for (const double radius : {0.02, 0.05, 0.1, 0.2, 0.44})
        EXPECT_NEAR(cells_to(fine, radius), r * cells_to(coarse, radius), std::max(1.0, r))
            << r << ' ' << radius;
      const auto rows = [](int from, int to) { return static_cast<double>(to - from); };
      EXPECT_NEAR(rows(0, fine.j_zone_bottom), r * rows(0, coarse.j_zone_bottom), 2.0);
      EXPECT_NEAR(rows(fine.j_zone_bottom, fine.j_face), r * rows(coarse.j_zone_bottom, coarse.j_face), 2.0);
      EXPECT_NEAR(rows(fine.j_face, fine.j_zone_top), r * rows(coarse.j_face, coarse.j_zone_top), 2.0);
      EXPECT_NEAR(static_cast<double>(fine.y.size()), r * static_cast<double>(coarse.y.size()), 6.0);
    }
  }
}

TEST(Refinement, KeepsThePointsInACellAndTheDensityMultipliesThem) {
  const auto points_a_cell = [](const solver::Setup& setup) {
    const Numerics numerics = actual_setup(setup).numerics;
    const PointZone& near = numerics.zones.front();
    const double width = setup.penetrometer.diameter / 2.0 / numerics.face_elements;
    return width * near.columns / near.outer_radius * numerics.near_height * near.rows_per_metre;
  };
  const double baseline = points_a_cell(with(1.0));
  for (const double r : {0.5, 1.5, 2.0, 4.0})
    EXPECT_NEAR(points_a_cell(with(r)), baseline, 1e-9 * baseline) << r;
  for (const double density : {2.0, 4.0, 16.0})
    EXPECT_NEAR(points_a_cell(with(1.0, density)) / baseline, density, 0.02 * density);
}

// Twice as fine: about four times the points and twice the steps of a short push.
TEST(Refinement, IsWhatAPushRunsOn) {
  Observer nobody;
  const auto push = [&](double refinement, double point_density) {
    solver::Setup setup = with(refinement, point_density);
    setup.penetrometer.final_depth = 0.024;
    setup.numerics.step_levels = 0;  // a push ends where all cells meet
    return simulate(setup, nobody);
  };
  const Outcome coarse = push(0.5, 1.0), baseline = push(1.0, 1.0), dense = push(0.5, 4.0);
  ASSERT_EQ(baseline.status, Status::completed) << baseline.reason;
  ASSERT_EQ(coarse.status, Status::completed) << coarse.reason;
  EXPECT_NEAR(static_cast<double>(baseline.material_points) / static_cast<double>(coarse.material_points),
              4.0, 0.1);
  EXPECT_NEAR(static_cast<double>(baseline.steps) / static_cast<double>(coarse.steps), 2.0, 0.2);
  EXPECT_EQ(dense.material_points, baseline.material_points);
  EXPECT_NEAR(static_cast<double>(dense.steps) / static_cast<double>(coarse.steps), 1.0, 0.1);
}

}  // namespace
}  // namespace cpt::solver

// The moving mesh: cells tile the chamber, follow the cone, and every point finds its cell.
#include "solver/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "solver/presets.hpp"

namespace cpt::solver {
namespace {

double chamber_volume(const Mesh& mesh) {
  double volume = 0.0;  // per radian, exact for edges that are linear in xi
  for (const Cell& cell : mesh.cells()) {
    const CellShape s = mesh.shape(cell);
    const double h0 = s.zt0 - s.zb0, h1 = s.zt1 - s.zb1;
    volume += 2.0 * s.a * (s.r_c * h0 + s.a * h1 / 3.0);
  }
  return volume;
}

TEST(Mesh, CellsFillTheChamberAroundThePenetrometer) {
  for (const Preset preset : all_presets()) {
    const solver::Setup setup = make_setup(Profile::homogeneous_sand, preset);
    Mesh mesh(chamber_layout(setup));
    const double R = setup.chamber.radius, R_cone = setup.penetrometer.diameter / 2.0;
    const double face_height = R_cone * std::sqrt(3.0);
    for (const double depth : {face_height, 0.2, 0.53}) {
      mesh.move_tip_to(depth);
      const double shaft = depth - face_height + setup.chamber.surcharge_height;
      const double expected = 0.5 * R * R * (setup.chamber.soil_height + setup.chamber.surcharge_height) -
                              0.5 * R_cone * R_cone * (shaft + face_height / 3.0);
      EXPECT_NEAR(chamber_volume(mesh) / expected, 1.0, 1e-12) << to_string(preset) << " at " << depth;
    }
  }
}

// A cell hardly higher or wider than the spacing of its material points is empty now and then, and its stress
// gone with it: five such cells of a thousand once tripled the scatter of q_c.
TEST(Mesh, CellsStayLargerThanTheSpacingOfTheirMaterialPoints) {
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) {
      const solver::Setup setup = make_setup(profile, preset);
      Mesh mesh(chamber_layout(setup));
      for (const double depth : {mesh.tip_depth(), setup.penetrometer.final_depth}) {
        mesh.move_tip_to(depth);
        double lowest = 1e9, narrowest = 1e9;
        for (const Cell& cell : mesh.cells()) {
          const CellShape s = mesh.shape(cell);
          double inner = 0.0;
          for (const PointZone& zone : setup.numerics.zones) {
            if (s.r_c < zone.outer_radius || &zone == &setup.numerics.zones.back()) {
              lowest = std::min(lowest, (s.zt0 - s.zb0) * zone.rows_per_metre);
              narrowest = std::min(narrowest, 2.0 * s.a * zone.columns / (zone.outer_radius - inner));
              break;
            }
            inner = zone.outer_radius;
          }
        }
        EXPECT_GE(lowest, 1.2) << to_string(profile) << ' ' << to_string(preset) << " at " << depth;
        EXPECT_GE(narrowest, 1.2) << to_string(profile) << ' ' << to_string(preset) << " at " << depth;
      }
    }
}

TEST(Mesh, FaceAndShaftNodesLieOnThePenetrometer) {
  const solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  Mesh mesh(chamber_layout(setup));
  mesh.move_tip_to(0.3);
  for (const std::int32_t n : mesh.face_nodes())
    EXPECT_NEAR(mesh.node_z(n), -0.3 + mesh.node_r(n) * std::sqrt(3.0), 1e-12);
  for (const std::int32_t n : mesh.shaft_nodes()) {
    EXPECT_NEAR(mesh.node_r(n), setup.penetrometer.diameter / 2.0, 1e-15);
    EXPECT_GT(mesh.node_z(n), mesh.node_z(mesh.face_nodes().back()));
  }
}

TEST(Mesh, LocatesEveryPointInTheCellThatHoldsIt) {
  const solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  Mesh mesh(chamber_layout(setup));
  mesh.move_tip_to(0.37);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> r(0.0, setup.chamber.radius), z(-setup.chamber.soil_height, 0.5);
  const double R_cone = setup.penetrometer.diameter / 2.0;
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const double r_i = r(random), z_i = z(random);
    if (r_i < R_cone && z_i > -0.37 + r_i * std::sqrt(3.0)) continue;
    const Location at = mesh.locate(r_i, z_i);
    const CellShape s = mesh.shape(mesh.cells()[at.cell]);
    const double zb = s.zb0 + s.zb1 * at.xi, zt = s.zt0 + s.zt1 * at.xi;
    ASSERT_NEAR(s.r_c + s.a * at.xi, r_i, 1e-12);
    ASSERT_NEAR(0.5 * ((1 - at.eta) * zb + (1 + at.eta) * zt), z_i, 1e-12);
    ++inside;
  }
  EXPECT_GT(inside, 19000);
}

TEST(Mesh, ClampsPointsOutside) {
  const solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::quick);
  Mesh mesh(chamber_layout(setup));
  mesh.move_tip_to(0.3);
  EXPECT_EQ(mesh.locate(1.0, -0.5).xi, 1.0);
  EXPECT_EQ(mesh.locate(0.2, 5.0).eta, 1.0);
  EXPECT_EQ(mesh.locate(0.2, -5.0).eta, -1.0);
  // Inside the shaft: the column beside it; inside the cone: the cell under the face.
  const Location shaft = mesh.locate(0.005, -0.1);
  EXPECT_EQ(shaft.xi, -1.0);
  EXPECT_NEAR(mesh.shape(mesh.cells()[shaft.cell]).r_c - mesh.shape(mesh.cells()[shaft.cell]).a,
              setup.penetrometer.diameter / 2.0, 1e-15);
  const Location cone = mesh.locate(0.003, -0.3 + 0.01);
  EXPECT_EQ(cone.eta, 1.0);
}

TEST(Mesh, HangingNodesLieBetweenTheirNeighbours) {
  const solver::Setup setup = make_setup(Profile::homogeneous_sand, Preset::paper);
  Mesh mesh(chamber_layout(setup));
  mesh.move_tip_to(0.41);
  EXPECT_FALSE(mesh.hanging_nodes().empty());
  for (const HangingNode& h : mesh.hanging_nodes()) {
    const double w = mesh.hanging_weight(h);
    EXPECT_NEAR(mesh.node_z(h.node), (1 - w) * mesh.node_z(h.lower) + w * mesh.node_z(h.upper), 1e-14);
  }
}

}  // namespace
}  // namespace cpt::solver

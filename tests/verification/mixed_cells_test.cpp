// Cells that hold several soils, against the series solution of a layered column: one traction through all
// layers, each with its own strain.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/setup.hpp"
#include "solver/soils/law.hpp"
#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {
namespace {

constexpr double far = 1e5;  // [m] from the axis, where the plane r-z does not feel the hoop
constexpr double height = 0.4;

struct Layered {
  std::vector<double> tops;  // [m] of all soils but the last, from below
  [[nodiscard]] std::int32_t at(double z) const {
    std::int32_t soil = 0;
    while (soil < static_cast<std::int32_t>(tops.size()) && z > tops[static_cast<std::size_t>(soil)]) ++soil;
    return soil;
  }
};

// A column far from the axis of `rows` cells, sixteen points in each.
Model column(
    SoilModels soils, const Layered& layers, int rows, ModelSettings settings,
    const std::function<void(Point&)>& set = [](Point&) {}) {
  Mesh mesh(plain_layout(lines(far, far + 0.1, 1), lines(0.0, height, rows)));
  const std::vector<Point> points = fill(mesh, 4, 2000.0, set);
  std::vector<std::int32_t> material;
  for (const Point& point : points) material.push_back(layers.at(point.z));
  settings.gravity = 0.0;
  settings.materials = static_cast<std::int32_t>(soils.size());
  return Model(mesh, points, material, std::move(soils), settings);
}

struct Means {
  double volume = 0.0, s_rr = 0.0, s_zz = 0.0, s_tt = 0.0, s_rz = 0.0;
  [[nodiscard]] double p() const { return -(s_rr + s_zz + s_tt) / 3.0; }
};

std::vector<Means> means(const Model& model) {
  const std::int32_t soils = model.points().materials();
  std::vector<Means> found(static_cast<std::size_t>(soils));
  for (std::int32_t b = 0; b < model.points().bucket_count(); ++b) {
    const PointFields p = model.points().fields(model.points().bucket(b));
    Means& m = found[static_cast<std::size_t>(b % soils)];
    for (std::int32_t k = 0; k < model.points().bucket(b).count; ++k) {
      m.volume += p.volume[k];
      m.s_rr += p.volume[k] * p.s_rr[k];
      m.s_zz += p.volume[k] * p.s_zz[k];
      m.s_tt += p.volume[k] * p.s_tt[k];
      m.s_rz += p.volume[k] * p.s_rz[k];
    }
  }
  for (Means& m : found) {
    m.s_rr /= m.volume;
    m.s_zz /= m.volume;
    m.s_tt /= m.volume;
    m.s_rz /= m.volume;
  }
  return found;
}

// One step in which every node moves with (rate_r z, rate_z z).
void strain_step(Model& model, double rate_r, double rate_z, double dt) {
  model.compute_nodal_forces();
  model.accelerate(0.0);
  for (std::int32_t n = 0; n < model.mesh().node_count(); ++n) {
    const double z = model.mesh().node_z(n);
    drive(model, n, rate_r * z, rate_z * z);
  }
  model.move_points(dt);
}

struct Elastic {
  double E, nu;
  [[nodiscard]] double M() const { return E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)); }
  [[nodiscard]] double G() const { return E / (2 * (1 + nu)); }
};
constexpr Elastic sand{3e7, 0.2}, clay{1.65e6, 0.4995}, surcharge{1e6, 1.0 / 3.0};

SoilModels elastic_soils(const std::vector<Elastic>& list) {
  SoilModels soils;
  for (const Elastic& soil : list) soils.push_back(elastic_soil(soil.E, soil.nu));
  return soils;
}

// One cell whose three soils fill a quarter, a half and a quarter of it.
TEST(MixedCells, CompressionAndShearGiveTheSeriesSolution) {
  const double strain = 1e-6;
  Model model = column(elastic_soils({clay, sand, surcharge}), {{0.1, 0.3}}, 1, {});
  const double compliance = 0.25 / clay.M() + 0.5 / sand.M() + 0.25 / surcharge.M();
  const double softness = 0.25 / clay.G() + 0.5 / sand.G() + 0.25 / surcharge.G();
  for (int i = 0; i < 10; ++i) strain_step(model, 2.0 * strain, -strain, 1.0);
  for (const Means& soil : means(model)) {
    EXPECT_NEAR(soil.s_zz, -10 * strain / compliance, 1e-4 * 10 * strain / compliance);
    EXPECT_NEAR(soil.s_rz, 20 * strain / softness, 1e-4 * 20 * strain / softness);
  }
  EXPECT_EQ(model.limited_share(), 0.0);
}

// A column between a fixed bottom and a top that was pressed down and held: at rest the stress is the series
// solution's, wherever the interfaces fall in the cells.
double stress_error(int rows) {
  const double pressed = 1e-6;
  const Layered layers{{0.075, 0.225}};
  ModelSettings settings;
  settings.local_damping = 0.3;
  settings.courant = 0.5;
  Model model = column(elastic_soils({sand, clay, surcharge}), layers, rows, settings);
  const int steps = 600 * rows, pressing = 60 * rows;
  for (int i = 0; i < steps; ++i) {
    model.compute_nodal_forces();
    const double dt = model.stable_time_step();
    model.accelerate(dt);
    for (std::int32_t n = 0; n < model.mesh().node_count(); ++n) {
      const double z = model.mesh().node_z(n);
      double v_z = model.nodes().velocity.z[n];
      if (z < 1e-9) v_z = 0.0;
      if (z > height - 1e-9) v_z = i < pressing ? -pressed / (pressing * dt) : 0.0;
      model.set_velocity(n, 0.0, v_z);
      model.hold({n, 1.0, 0.0, 0.0, false});
      if (z < 1e-9 || z > height - 1e-9) model.hold({n, 0.0, 1.0, v_z, false});
    }
    model.move_points(dt);
  }
  const double exact = -pressed / (0.075 / sand.M() + 0.15 / clay.M() + (height - 0.225) / surcharge.M());
  double largest = 0.0;
  for (const Means& soil : means(model)) largest = std::max(largest, std::abs(soil.s_zz / exact - 1.0));
  return largest;
}

TEST(MixedCells, TheColumnIsExactOnEveryMesh) {
  for (const int rows : {4, 8, 16}) EXPECT_LT(stress_error(rows), 0.002) << rows << " rows";
}

SoilModels norsand_and_tresca() {
  SoilModels soils;
  const Mechanisms none;
  soils.push_back(law_of(LawParameters{NorSandParameters{}}).model(NorSandParameters{}, none));
  soils.push_back(law_of(LawParameters{TrescaParameters{}}).model(TrescaParameters{}, none));
  return soils;
}

// Shear of a cell of sand over clay at a constant volume: the sand dilates, the clay neither does nor may
// stop it by tension; both carry the clay's strength in shear.
TEST(MixedCells, SandMayDilateBesideClay) {
  for (const double interface : {0.1, 0.2, 0.3}) {
    const SoilModels probe = norsand_and_tresca();
    const double p_0 = 100e3;
    const double e = NorSandParameters{}.e_max -
                     NorSandParameters{}.D_r * (NorSandParameters{}.e_max - NorSandParameters{}.e_min);
    const double p_i = probe[0]->start({0.0, -p_0, -p_0, -p_0, 0.0, e})[0];
    SoilModels soils = norsand_and_tresca();
    Model model = column(std::move(soils), {{interface}}, 1, {}, [&](Point& p) {
      p.s_rr = p.s_zz = p.s_tt = -p_0;
      p.e = e;
      p.h_0 = p_i;
    });
    for (int i = 0; i < 4000; ++i) strain_step(model, 1e-4, 0.0, 1.0);
    const std::vector<Means> soil = means(model);
    const double s_u = TrescaParameters{}.s_u;
    EXPECT_NEAR(soil[1].s_rz, s_u, 0.01 * s_u) << interface;
    EXPECT_NEAR(soil[0].s_rz, s_u, 0.05 * s_u) << interface;
    EXPECT_NEAR(soil[0].s_zz, soil[1].s_zz, 1e3) << interface;
    EXPECT_NEAR(soil[1].p(), -soil[0].s_zz, 2.0 * s_u) << interface;
    EXPECT_GT(soil[1].p(), 0.0) << interface;
    EXPECT_LT(model.limited_share(), 0.001) << interface;
  }
}

}  // namespace
}  // namespace cpt::solver::test

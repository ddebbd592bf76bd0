// One-dimensional columns with closed-form answers: settlement under self-weight and a standing P-wave.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {
namespace {

constexpr double H = 1.0, density = 2000.0, E = 1e7, nu = 0.25;
const double M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));  // [Pa] oedometer modulus

void fix_column(Model& model, bool fix_top) {
  const Nodes& nodes = model.nodes();
  for (std::int32_t n = 0; n < model.mesh().node_count(); ++n) {
    const double z = model.mesh().node_z(n);
    const bool fixed = z < 1e-9 || (fix_top && z > H - 1e-9);
    model.set_velocity(n, 0.0, fixed ? 0.0 : nodes.velocity.z[n]);
    model.hold({n, 1.0, 0.0, 0.0, false});
    if (fixed) model.hold({n, 0.0, 1.0, 0.0, false});
  }
}

// Relative error of the vertical stress profile of a column that settled under its own weight.
double oedometer_error(int cells) {
  ModelSettings settings;
  settings.local_damping = 0.3;
  settings.courant = 0.5;
  Model model =
      elastic_model(plain_layout(lines(0.0, 0.2, 2), lines(0.0, H, cells)), E, nu, density, settings);
  const int steps = 4000;
  for (int i = 0; i < steps; ++i) {
    model.compute_nodal_forces();
    model.accelerate(model.stable_time_step());
    fix_column(model, false);
    model.move_points(model.stable_time_step());
  }
  double error = 0.0, norm = 0.0;
  for_each_point(model, [&](const PointFields& p, std::int32_t k) {
    const double exact = -density * 9.81 * (H - p.z[k]);
    error += p.volume[k] * std::pow(p.s_zz[k] - exact, 2);
    norm += p.volume[k] * exact * exact;
    EXPECT_NEAR(p.s_rr[k], nu / (1 - nu) * p.s_zz[k], 1e-6 * density * 9.81 * H);
  });
  return std::sqrt(error / norm);
}

TEST(Column, SettlesToTheOedometerSolution) {
  const double coarse = oedometer_error(8), fine = oedometer_error(16);
  EXPECT_LT(fine, 0.03);
  EXPECT_GT(std::log2(coarse / fine), 0.9) << "errors " << coarse << " and " << fine;
}

// Standing wave v = V sin(pi z / H) cos(omega t) between fixed ends. After a quarter of a period the velocity
// is zero; the modal amplitude that is left, over V, is the phase error.
double phase_error(int cells) {
  ModelSettings settings;
  settings.gravity = 0.0;
  settings.courant = 0.25;
  const double V = 1e-4, k = std::numbers::pi / H, omega = k * std::sqrt(M / density);
  Model model = elastic_model(plain_layout(lines(0.0, 0.2, 1), lines(0.0, H, cells)), E, nu, density,
                              settings, 4, [&](Point& p) { p.v_z = V * std::sin(k * p.z); });
  model.compute_nodal_forces();
  const double end = std::numbers::pi / (2.0 * omega);
  const int steps = static_cast<int>(std::ceil(end / model.stable_time_step()));
  // The start has zero stress, so velocities belong to the middle of the steps.
  const double dt = end / (steps - 0.5);
  for (int i = 0; i < steps; ++i) {
    if (i > 0) model.compute_nodal_forces();
    model.accelerate(dt);
    fix_column(model, true);
    model.move_points(dt);
  }
  double amplitude = 0.0, norm = 0.0;
  for_each_point(model, [&](const PointFields& p, std::int32_t i) {
    const double mode = std::sin(k * p.z[i]);
    amplitude += p.volume[i] * p.v_z[i] * mode;
    norm += p.volume[i] * mode * mode;
  });
  return std::abs(amplitude / norm) / V;
}

TEST(Column, StandingWaveHasTheRightPeriodWithSecondOrder) {
  const double e8 = phase_error(8), e16 = phase_error(16), e32 = phase_error(32);
  EXPECT_LT(e32, 0.01);
  EXPECT_GT(std::log2(e8 / e16), 1.8) << e8 << " " << e16 << " " << e32;
  EXPECT_GT(std::log2(e16 / e32), 1.8) << e8 << " " << e16 << " " << e32;
}

}  // namespace
}  // namespace cpt::solver::test

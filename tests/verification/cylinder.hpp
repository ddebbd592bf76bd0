// A cylindrical cavity in plane strain that opens at constant speed; the mesh follows it.
#pragma once

#include <cmath>
#include <vector>

#include "tests/verification/small_model.hpp"

namespace cpt::solver::test {

class Cylinder {
 public:
  /// Cavity radius a, outer radius b [m], cells across, initial isotropic pressure p_0 [Pa] held at b.
  Cylinder(double a, double b, int cells, double p_0) : a_(a), p_0_(p_0) {
    // Widths in geometric progression: the same number of cells for each doubling of the radius.
    for (int i = 0; i <= cells; ++i) r0_.push_back(a * std::pow(b / a, static_cast<double>(i) / cells));
  }

  /// Opens the cavity to radius `to` in time `duration` [s]; returns the total pressure in it at the end
  /// [Pa], averaged over the last twentieth.
  double expand(std::unique_ptr<const SoilModel> soil, double to, double duration) {
    const double height = 0.05, density = 2000.0;
    MeshLayout layout = plain_layout(r0_, lines(0.0, height, 2));
    ModelSettings settings;
    settings.gravity = 0.0;
    settings.mass_scaling = mass_scaling;
    settings.courant = 0.5;
    Mesh mesh(layout);
    std::vector<Point> points =
        fill(mesh, 4, density, [this](Point& p) { p.s_rr = p.s_zz = p.s_tt = -p_0_; });
    Model model(mesh, points, std::vector<std::int32_t>(points.size(), 0), one_soil(std::move(soil)),
                settings);

    double t = 0.0, a = a_, impulse = 0.0, time = 0.0;
    std::vector<double> r = r0_;
    while (t < duration) {
      model.compute_nodal_forces();
      const double dt = model.stable_time_step(), speed = (to - a_) / duration;
      for (const std::int32_t n : model.mesh().wall_nodes())
        model.nodes().force.r[n] -=
            p_0_ * r.back() * height / 2.0 * (is_middle(model.mesh(), n, height) ? 1.0 : 0.5);
      model.accelerate(dt);
      double reaction = 0.0;
      for (std::int32_t n = 0; n < model.mesh().node_count(); ++n) {
        double v_r = model.nodes().velocity.r[n];
        if (model.mesh().node_r(n) < a + 1e-9) {
          reaction += model.nodes().inertia[n] * (speed - v_r) / dt;
          v_r = speed;
        }
        model.set_velocity(n, v_r, 0.0);
        model.hold({n, 0.0, 1.0, 0.0, false});
        if (model.mesh().node_r(n) < a + 1e-9) model.hold({n, 1.0, 0.0, speed, false});
      }
      // Columns move as an incompressible body would.
      a += speed * dt;
      for (std::size_t i = 0; i < r.size(); ++i) r[i] = std::sqrt(r0_[i] * r0_[i] + a * a - a_ * a_);
      model.mesh().move_columns_to(r);
      model.move_points(dt);
      t += dt;
      if (t > 0.95 * duration) {
        impulse += reaction / (a * height) * dt;
        time += dt;
      }
    }
    return impulse / time;
  }

  double mass_scaling = 1.0;

 private:
  static bool is_middle(const Mesh& mesh, std::int32_t n, double height) {
    return mesh.node_z(n) > 1e-9 && mesh.node_z(n) < height - 1e-9;
  }
  double a_, p_0_;
  std::vector<double> r0_;
};

}  // namespace cpt::solver::test

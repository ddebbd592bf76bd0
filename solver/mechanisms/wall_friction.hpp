// Friction between the sand and the chamber's wall takes away vertical stress with depth.
//
//   d sigma_v / dz = gamma' - 2 mu K_0 sigma_v / R      Janssen (1895)
//
// solved layer by layer. The wall's shear tau = mu K_0 sigma_v acts on the soil at the wall throughout the
// push; inside it falls linearly to zero on the axis, which keeps vertical equilibrium at every radius.
#pragma once

#include <cmath>

namespace cpt::solver {

struct WallFriction {
  double coefficient = 0.0;  // [-] tangent of the mobilized friction angle on the wall

  [[nodiscard]] bool on() const { return coefficient != 0.0; }
  /// Vertical stress [Pa] below a thickness [m] of soil of unit weight `weight` [N/m3] with sigma_v [Pa] on
  /// top.
  [[nodiscard]] double below(double sigma_v, double weight, double thickness, double K_0, double R) const {
    if (!on() || K_0 <= 0.0) return sigma_v + weight * thickness;
    const double length = R / (2.0 * coefficient * K_0);
    const double left = std::exp(-thickness / length);
    return sigma_v * left + weight * length * (1.0 - left);
  }
};

}  // namespace cpt::solver

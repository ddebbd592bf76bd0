// Clay whose strength rises with depth, as consolidation under its own weight leaves it.
//
//   s_u(z) = s_u + gradient z
#pragma once

namespace cpt::solver {

struct StrengthGradient {
  double gradient = 0.0;  // [Pa/m]

  [[nodiscard]] bool on() const { return gradient != 0.0; }
  /// Change of s_u [Pa] at a depth [m].
  [[nodiscard]] double at(double depth) const { return gradient * depth; }
};

}  // namespace cpt::solver

// Clay that drained and gained strength near its top.
//
//   s_u(z) = s_u (1 + increase exp(-z / decay))
#pragma once

#include <cmath>

namespace cpt::solver {

struct ClayCrust {
  double increase = 0.0;  // [-] of s_u at the soil's top, relative
  double decay = 0.05;    // [m]

  [[nodiscard]] bool on() const { return increase != 0.0; }
  /// Relative increase of s_u [-] at a depth [m].
  [[nodiscard]] double at(double depth) const { return increase * std::exp(-depth / decay); }
};

}  // namespace cpt::solver

// K_0 that changes with depth, as preloading or compacting in stages leaves it.
//
//   sigma_h(z) = K_0 sigma_v(z) (1 + change (z - z_mid) / z_final),  z_mid = z_final / 2, below z_final as
//   there
//
// A stress of depth alone is in equilibrium whatever its horizontal part is; walls of all kinds begin with
// it. With wall friction the vertical stress stays that of the K_0 given.
#pragma once

#include <algorithm>

namespace cpt::solver {

struct StressRatioTrend {
  double change = 0.0;  // [-] share of K_0, at the push's final depth less at the top
  double over = 0.0;    // [m] no input: z_final where another push comes first; 0: that of the push

  [[nodiscard]] bool on() const { return change != 0.0; }
  /// Factor on the horizontal stress [-] at a depth [m].
  [[nodiscard]] double at(double depth, double final_depth) const {
    return 1.0 + change * (std::min(1.0, depth / (over > 0.0 ? over : final_depth)) - 0.5);
  }
};

}  // namespace cpt::solver

// The stress at the soil's top differs from that of the cushion: arching and friction in the top's frame.
//
//   sigma'_v = (1 - loss) sigma'_v,cushion at the soil's top, with K_0 unchanged
#pragma once

namespace cpt::solver {

struct CushionTransfer {
  double loss = 0.0;  // [-] share of the cushion's stress that does not reach the soil; negative for a gain

  /// Factor on sigma_v0 and sigma_h0 [-].
  [[nodiscard]] double factor() const { return 1.0 - loss; }
};

}  // namespace cpt::solver

// Clay that loses strength with plastic shear.
//
//   s_u = s_u0 (1 - loss (1 - exp(-3 xi / xi_95)))      Einav & Randolph (2005), Int. J. Numer. Meth. Engng
//   63, 991
//
// xi is the accumulated plastic shear strain; at xi_95 95 % of the loss has happened. Their delta_rem is 1 -
// loss.
#pragma once

namespace cpt::solver {

struct StrainSoftening {
  double loss = 0.0;    // [-] share of s_u that is lost when fully remoulded
  double xi_95 = 20.0;  // [-] accumulated plastic shear strain (1 = 100 %)

  [[nodiscard]] bool on() const { return loss != 0.0; }
};

}  // namespace cpt::solver

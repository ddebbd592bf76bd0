// A worn cone: thinner and blunter than its drawing. q_c is still the force over the nominal area.
//
//   d = d_nominal - diameter_loss,  apex = apex_nominal + apex_increase
#pragma once

namespace cpt::solver {

struct WornCone {
  double diameter_loss = 0.0;  // [m]
  double apex_increase = 0.0;  // [rad]
};

}  // namespace cpt::solver

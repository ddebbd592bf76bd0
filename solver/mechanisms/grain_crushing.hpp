// Grains that break: beyond a pressure the critical state line falls faster.
//
//   e_c(p) = e_cs0 - lambda (p / p_a)^m - slope max(0, ln(p / pressure))
//
// the steeper branch of Russell & Khalili (2004), Can. Geotech. J. 41, 1179-1192. It acts in NorSand through
// the state parameter and its slope (solver/constitutive/norsand_state.hpp).
#pragma once

#include <algorithm>
#include <cmath>

namespace cpt::solver {

struct GrainCrushing {
  double slope = 0.0;       // [-] of the crushing branch in e over ln p
  double pressure = 1.0e6;  // [Pa] where it begins

  /// What crushing takes from the critical void ratio [-] at a mean stress [Pa].
  [[nodiscard]] double at(double p) const { return slope * std::max(0.0, std::log(p / pressure)); }
};

}  // namespace cpt::solver

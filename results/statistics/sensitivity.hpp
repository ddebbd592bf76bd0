// Sensitivity index of one parameter and its noise floor, as pure functions. The ledger's view `sensitivity`
// computes the same in SQL.
#pragma once

#include <limits>

namespace cpt::results {

/// SI = (q_upper - q_lower) / q_upper (Yost et al. 2023, eq. 3, after Hoffman & Gardner 1983), with q_c
/// averaged in a window at the parameter's upper and lower bound; the baseline's where a bound equals the
/// baseline. Negative where q_c falls as the parameter rises; not bounded by -1. NaN unless q_upper > 0 and
/// both are numbers.
[[nodiscard]] inline double sensitivity_index(double q_lower, double q_upper) {
  if (!(q_upper > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return (q_upper - q_lower) / q_upper;
}

/// SI_noise = (max - min) / max of q_c inside the window of the baseline run (Yost et al. 2023, section 5.1).
/// NaN unless max > 0.
[[nodiscard]] inline double noise_index(double q_min, double q_max) {
  if (!(q_max > 0.0)) return std::numeric_limits<double>::quiet_NaN();
  return (q_max - q_min) / q_max;
}

}  // namespace cpt::results

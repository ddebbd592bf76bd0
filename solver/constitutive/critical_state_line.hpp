// The exponential critical state line.
#pragma once

#include <cmath>

#include "solver/mechanisms/grain_crushing.hpp"
#include "solver/soils/norsand.hpp"

namespace cpt::solver {

inline constexpr double reference_pressure =
    100.0e3;  // [Pa] p_a of the critical state line and the stiffness

/// e_c(p) = e_cs0 - lambda (p / p_a)^m, less what crushing takes: Li & Wang (1998), parameters of Yost et al.
/// (2023), Table 2.
struct CriticalStateLine {
  double e_cs0;   // [-] void ratio at p' = 0
  double lambda;  // [-]
  double m;       // [-]
  GrainCrushing crushing;

  explicit CriticalStateLine(const NorSandParameters& sand, const GrainCrushing& grain_crushing = {})
      : e_cs0(sand.e_cs0), lambda(sand.lambda), m(sand.m), crushing(grain_crushing) {}

  /// Critical void ratio [-] at a mean effective stress p >= 0 [Pa].
  [[nodiscard]] double void_ratio(double p) const {
    return e_cs0 - lambda * std::pow(p / reference_pressure, m) - crushing.at(p);
  }
  /// -de_c / d ln p [-].
  [[nodiscard]] double slope(double p) const {
    return m * lambda * std::pow(p / reference_pressure, m) + (p > crushing.pressure ? crushing.slope : 0.0);
  }
};

}  // namespace cpt::solver

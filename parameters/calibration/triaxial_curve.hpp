// A drained triaxial test as a laboratory reports it.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "solver/soils/norsand.hpp"

namespace cpt::calibration {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// One reading. Strains are engineering strains (change over initial length or volume), compression-positive.
struct Reading {
  double eps_a;              // [-] axial strain
  double q;                  // [Pa] deviator stress
  double eps_v = not_given;  // [-] volumetric strain; NaN where the file has none
};

/// Isotropic consolidation to p_0, then axial compression at constant cell pressure, drained.
struct TriaxialCurve {
  std::string name;               ///< as the file calls the test; its file name without ending otherwise
  double p_0 = not_given;         // [Pa] mean effective stress before shearing
  double e_0 = not_given;         // [-] void ratio before shearing; NaN: from D_r
  double D_r = not_given;         // [-] relative density before shearing; NaN: from e_0
  double G_0 = not_given;         // [Pa] shear modulus at small strains before shearing; NaN: not measured
  std::vector<Reading> readings;  ///< axial strain does not fall
};

/// Void ratio [-] before shearing; NaN where the curve gives neither it nor a relative density.
[[nodiscard]] inline double void_ratio_before(const TriaxialCurve& curve,
                                              const solver::NorSandParameters& sand) {
  return std::isnan(curve.e_0) ? sand.e_max - curve.D_r * (sand.e_max - sand.e_min) : curve.e_0;
}

/// The element test has natural strains, the laboratory engineering strains; and the other way.
[[nodiscard]] inline double natural_strain(double engineering) { return -std::log1p(-engineering); }
[[nodiscard]] inline double engineering_strain(double natural) { return -std::expm1(-natural); }

}  // namespace cpt::calibration

// A drained triaxial test as a laboratory reports it.
#pragma once

#include <limits>
#include <string>
#include <vector>

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
  std::vector<Reading> readings;  ///< axial strain does not fall
};

}  // namespace cpt::calibration

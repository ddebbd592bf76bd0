// NorSand's hardening modulus H from a drained triaxial test.
#pragma once

#include <string>

#include "parameters/calibration/triaxial_curve.hpp"
#include "solver/setup.hpp"

namespace cpt::calibration {

struct HardeningOptions {
  double fraction = 0.5;    // [-] of the largest measured q, in (0, 1]: the curve up to there is matched
  double H_lower = 1.0;     // [-] bounds of the search
  double H_upper = 2000.0;  // [-]
};

struct HardeningFit {
  double H = not_given;       // [-]
  double e_0 = not_given;     // [-] void ratio before shearing
  double p_0 = not_given;     // [Pa] mean effective stress before shearing
  double psi_0 = not_given;   // [-] state parameter before shearing, e_0 - e_c(p_0)
  double eps_a = not_given;   // [-] axial strain up to which the curve was matched
  int readings = 0;           // [-] that were matched
  double E_test = not_given;  // [Pa] secant stiffness q / eps_a at that strain, measured
  double E_sand = not_given;  // [Pa] the same of the simulated test at H
  double misfit = not_given;  // [-] root mean square of the difference in q, over the q at that strain
  double eps_v_misfit =
      not_given;        // [-] root mean square of the difference in volumetric strain, all readings
  std::string problem;  ///< why there is no H, or why it is not to be trusted; empty if all is well
};

/// The H with which a single-element test of `sand` comes nearest, in the least-squares sense of q, to the
/// initial part of the measured curve. All other parameters stay as they are, as in Yost et al. (2023),
/// section 4.2, which matches initial stiffness too but does not say by which measure. The search is Brent's
/// method on ln H in the neighbourhood of the best of a coarse row of values. e_0 or D_r, and p_0 must be
/// known. The volumetric strain plays no part in the search: its misfit is an independent check.
[[nodiscard]] HardeningFit fit_hardening(const TriaxialCurve& curve, const solver::NorSandParameters& sand,
                                         const HardeningOptions& options = {});

}  // namespace cpt::calibration

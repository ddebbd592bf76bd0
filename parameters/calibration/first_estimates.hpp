// What laboratory tests tell of NorSand's parameters by hand, one after the other: the start of a joint fit.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "parameters/calibration/fit_parameters.hpp"
#include "parameters/calibration/simulated_tests.hpp"

namespace cpt::calibration {

/// A triaxial test where it dilates most and where it ends. Stress ratio eta = q / p', dilatancy D = deps_v /
/// deps_q over a stretch of readings, contraction positive. NaN without volumetric strains.
struct TestStates {
  std::string name;
  double D_peak = not_given;    // [-] least dilatancy over any tenth of the test's strain
  double eta_peak = not_given;  // [-] there
  double p_peak = not_given;    // [Pa]
  double e_peak = not_given;    // [-]
  double D_end = not_given;     // [-] over the last fifth of the strain
  double q_change = not_given;  // [-] of q over the last fifth, straight line, over the q there
  double eta_end = not_given;   // [-]
  double p_end = not_given;     // [Pa]
  double e_end = not_given;     // [-]
  bool critical = false;        ///< |D_end| <= 0.05 and |q_change| <= 0.05: at critical state, nearly
};

struct FirstEstimate {
  const FitParameter* parameter;
  double value;  // in study units, inside the valid range
  std::string how;
};

struct FirstEstimates {
  std::vector<TestStates> states;  ///< of each triaxial test
  std::vector<FirstEstimate> estimates;
  solver::NorSandParameters sand;  ///< with them in place
};

/// In this order, each where the tests tell it and it is among `free`, else as `sand` has it:
///  - M_tc and N: eta = M_tc - (1 - N) D at peaks and ends (Nova 1982; Jefferies & Been 2015, section 2.3);
///  - e_cs0 and lambda, m as given: the critical state line through the tests' ends, each moved to D = 0 by
///    psi = D / chi_tc, as ends that still dilate have not arrived (Jefferies & Been 2015, section 2.2);
///  - chi_tc: D_min = chi_tc psi at the peaks (ibid., section 2.4); then the line again with it;
///  - G_ref and b: shear moduli at small strains;
///  - H: the median of the tests' own (hardening.hpp).
[[nodiscard]] FirstEstimates first_estimates(const LaboratoryTests& tests,
                                             const solver::NorSandParameters& sand,
                                             std::span<const FitParameter* const> free);

}  // namespace cpt::calibration

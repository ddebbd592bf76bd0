// Sand as NorSand has it: the parameters of a soil of this law.
#pragma once

#include <cstdint>

#include "solver/soils/random_field.hpp"

namespace cpt::solver {

class Law;

enum class DeviatoricFlow : std::uint8_t { radial, associated };
/// Which stress the initial yield surface passes through: the initial one, or that at rest under the same
/// vertical stress, K_0 = 1 - sin(phi_cs) (Jaky 1944), and the initial one where it lies outside.
enum class SandStart : std::uint8_t { initial_stress, at_rest };

/// NorSand with the exponential critical state line; baseline of Yost et al. (2023), Table 2.
struct NorSandParameters {
  double e_cs0 = 0.90;                  // [-] critical state void ratio at p' = 0
  double lambda = 0.012;                // [-] slope of the critical state line
  double m = 0.7;                       // [-] exponent of the critical state line
  double G_ref = 743.0;                 // [-] shear modulus factor
  double b = 0.57;                      // [-] exponent of the stiffness relation
  double e_min_star = 0.051;            // [-] void ratio at which volumetric strains are negligible
  double phi_cs = 0.52359877559829887;  // [rad] critical state friction angle (30 deg)
  double N = 0.1;                       // [-] dilatancy (volumetric coupling) parameter
  double chi_tc = 2.7;                  // [-] dilatancy coefficient in triaxial compression
  double nu = 0.2;                      // [-] Poisson's ratio
  double H = 25.0;                      // [-] hardening modulus
  double D_r = 0.36;                    // [-] relative density
  double e_min = 0.552;                 // [-] minimum void ratio
  double e_max = 0.890;                 // [-] maximum void ratio
  double rho_grains = 2650.0;           // [kg/m3] density of the grains
  SandStart start = SandStart::initial_stress;
  double OCR = 1.0;                 // [-] scales the initial p_i of that yield surface
  double cap_ratio = 1.3;           // [-] inner cap: p_i <= cap_ratio * p_mx
  double hardening_exponent = 2.0;  // [-] exponent of (p/p_i) in the hardening rule
  double p_min = 500.0;             // [Pa] below this mean stress the sand carries none
  DeviatoricFlow flow = DeviatoricFlow::associated;
  double substep_tolerance = 1e-3;  // [-] relative error of stress and p_i allowed in one sub-step
  RandomField D_r_field = {};       // of D_r over depth [-]

  [[nodiscard]] static const Law& law();
};

}  // namespace cpt::solver

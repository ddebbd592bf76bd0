// Clay as Modified Cam Clay has it: the parameters of a soil of this law.
#pragma once

namespace cpt::solver {

class Law;

/// Roscoe & Burland (1968). The defaults are a soft clay of no particular place.
struct ModifiedCamClayParameters {
  double M = 1.0;              // [-] stress ratio q / p' at the critical state
  double lambda = 0.20;        // [-] slope of the normal compression line in v over ln p'
  double kappa = 0.04;         // [-] slope of a swelling line
  double nu = 0.3;             // [-] Poisson's ratio
  double e_0 = 1.0;            // [-] void ratio before the push, at every depth
  double OCR = 1.0;            // [-] initial size of the yield surface over that through the initial stress
  double rho_grains = 2700.0;  // [kg/m3] density of the grains
  double p_min = 500.0;        // [Pa] below this mean stress the clay carries none

  [[nodiscard]] static const Law& law();
};

}  // namespace cpt::solver

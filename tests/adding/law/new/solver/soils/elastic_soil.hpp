// Linear elastic soil, which never yields: the parameters of a soil of this law.
#pragma once

namespace cpt::solver {

class Law;

/// The defaults are a stiff soil of no particular place.
struct ElasticSoilParameters {
  double E = 20.0e6;           // [Pa] Young's modulus
  double nu = 0.3;             // [-] Poisson's ratio
  double e_0 = 0.7;            // [-] void ratio before the push
  double rho_grains = 2650.0;  // [kg/m3] density of the grains

  [[nodiscard]] static const Law& law();
};

}  // namespace cpt::solver

// Soil with cohesion and friction, perfectly plastic: the parameters of a soil of this law.
#pragma once

namespace cpt::solver {

class Law;

/// Linear elasticity up to Mohr-Coulomb's pyramid and a tension cut-off. The defaults are a medium dense
/// sand.
struct MohrCoulombParameters {
  double E = 20.0e6;                 // [Pa] Young's modulus
  double nu = 0.3;                   // [-] Poisson's ratio
  double c = 0.0;                    // [Pa] cohesion
  double phi = 0.57595865315812877;  // [rad] friction angle (33 deg)
  double psi = 0.05235987755982989;  // [rad] dilation angle (3 deg)
  double sigma_t = 0.0;              // [Pa] tensile strength, at most c / tan(phi)
  double n_0 = 0.40;                 // [-] initial porosity
  double rho_grains = 2650.0;        // [kg/m3] density of the grains

  [[nodiscard]] static const Law& law();
};

}  // namespace cpt::solver

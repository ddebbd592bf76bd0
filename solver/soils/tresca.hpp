// Undrained clay as Tresca has it: the parameters of a soil of this law.
#pragma once

#include "solver/soils/random_field.hpp"

namespace cpt::solver {

class Law;

/// Tresca; baseline of Yost et al. (2023), Table 3.
struct TrescaParameters {
  double n_0 = 0.362;          // [-] initial porosity
  double s_u = 27.9e3;         // [Pa] undrained shear strength
  double G = 552.0e3;          // [Pa] shear modulus
  double nu = 0.4995;          // [-] undrained Poisson's ratio
  double rho_grains = 2700.0;  // [kg/m3] density of the grains
  RandomField s_u_field = {};  // of s_u over depth [Pa]

  [[nodiscard]] static const Law& law();
};

}  // namespace cpt::solver

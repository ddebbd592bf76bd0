#include "solver/mechanisms/strain_softening.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism strain_softening_mechanism() {
  return {
      .name = "strain_softening",
      .title = "clay that softens with strain",
      .equation = "s_u = s_u0 (1 - loss (1 - exp(-3 xi / xi_95)))",
      .source =
          "Einav & Randolph, Int. J. Numer. Meth. Engng 63 (2005) 991; xi_95 10 to 50, sensitivity up to 5",
      .signature = "q_c is lower throughout in constant proportion; f_s falls more.",
      .acts_on = tresca_only,
      .parameters = {
          {number<&Setup::mechanisms, &Mechanisms::strain_softening, &StrainSoftening::loss>(
               "strain_softening.loss", "1-δ_rem", none, 0.0, 0.99, tresca_only,
               "share of s_u lost when fully remoulded", "sensitivity 1 to 5"),
           0.0, 0.8},
          {number<&Setup::mechanisms, &Mechanisms::strain_softening, &StrainSoftening::xi_95>(
               "strain_softening.xi_95", "ξ_95", none, 0.1, 1000.0, tresca_only,
               "plastic shear strain at which 95 % of the loss has happened", "Einav & Randolph (2005)"),
           10.0, 50.0}}};
}

}  // namespace cpt::solver

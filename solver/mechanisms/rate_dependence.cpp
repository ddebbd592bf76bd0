#include "solver/mechanisms/rate_dependence.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism rate_dependence_mechanism() {
  return {.name = "rate_dependence",
          .title = "clay whose strength rises with the rate of strain",
          .equation = "s_u = s_u0 (1 + mu log10(max(rate, reference) / reference))",
          .source = "Einav & Randolph, Int. J. Numer. Meth. Engng 63 (2005) 991: mu 0.05 to 0.2",
          .signature =
              "q_c is higher throughout in constant proportion; at another speed of the push it changes.",
          .acts_on = tresca_only,
          .parameters = {
              {number<&Setup::mechanisms, &Mechanisms::rate_dependence, &RateDependence::mu>(
                   "rate_dependence.mu", "μ_rate", none, 0.0, 1.0, tresca_only,
                   "rise of s_u per tenfold rate of shear strain", "Einav & Randolph (2005)"),
               0.0, 0.2},
              {number<&Setup::mechanisms, &Mechanisms::rate_dependence, &RateDependence::reference_rate>(
                   "rate_dependence.reference_rate_per_s", "γ̇_ref", per_second, 1.0e-8, 10.0, tresca_only,
                   "rate of shear strain at which s_u was measured", "vane and laboratory tests"),
               0.003, 0.003}}};
}

}  // namespace cpt::solver

#include "solver/mechanisms/strength_gradient.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism strength_gradient_mechanism() {
  return {.name = "strength_gradient",
          .title = "clay whose strength rises with depth",
          .equation = "s_u(z) = s_u + gradient z",
          .source = "normally consolidated clay: 1 to 2 kPa/m in the field, more between drained plates",
          .signature = "q_c rises linearly with depth.",
          .acts_on = tresca_only,
          .parameters = {
              {number<&Setup::mechanisms, &Mechanisms::strength_gradient, &StrengthGradient::gradient>(
                   "strength_gradient.gradient_kPa_per_m", "k_su", kilopascals_per_metre, -100.0, 1000.0,
                   tresca_only, "rise of s_u with depth", "consolidation between drained plates"),
               0.0, 30.0}}};
}

}  // namespace cpt::solver

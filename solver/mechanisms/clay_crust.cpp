#include "solver/mechanisms/clay_crust.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism clay_crust_mechanism() {
  return {.name = "clay_crust",
          .title = "a drained crust on the clay",
          .equation = "s_u(z) = s_u (1 + increase exp(-z / decay))",
          .source = "drainage into the cushion or the next sand",
          .signature = "q_c is higher near the top of the clay and fades downward.",
          .acts_on = tresca_only,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::clay_crust, &ClayCrust::increase>(
                              "clay_crust.increase", "Δs_u/s_u", none, 0.0, 10.0, tresca_only,
                              "relative increase of s_u at the soil's top", "drainage into the cushion"),
                          0.0, 1.5},
                         {number<&Setup::mechanisms, &Mechanisms::clay_crust, &ClayCrust::decay>(
                              "clay_crust.decay_mm", "ℓ_crust", millimetres, 1.0, 2000.0, tresca_only,
                              "depth over which the increase falls to 1/e", "consolidation times of days"),
                          20.0, 120.0}}};
}

}  // namespace cpt::solver

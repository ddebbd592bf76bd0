#include "solver/mechanisms/worn_cone.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism worn_cone_mechanism() {
  return {.name = "worn_cone",
          .title = "a worn cone",
          .equation =
              "d = d_nominal - diameter_loss, apex = apex_nominal + apex_increase, q_c over the nominal area",
          .source = "ISO 22476-1 (2022): limits of wear",
          .signature = "q_c differs in constant proportion from the top down, in any soil.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::worn_cone, &WornCone::diameter_loss>(
                              "worn_cone.diameter_loss_mm", "Δd", millimetres, 0.0, 5.0, any_soil,
                              "what wear has taken from the diameter", "ISO 22476-1"),
                          0.0, 1.2},
                         {number<&Setup::mechanisms, &Mechanisms::worn_cone, &WornCone::apex_increase>(
                              "worn_cone.apex_increase_deg", "Δα", degrees, 0.0, 60.0, any_soil,
                              "how much blunter than its drawing the cone is", "ISO 22476-1"),
                          0.0, 20.0}}};
}

}  // namespace cpt::solver

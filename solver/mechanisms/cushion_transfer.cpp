#include "solver/mechanisms/cushion_transfer.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism cushion_transfer_mechanism() {
  return {.name = "cushion_transfer",
          .title = "a cushion whose stress does not all reach the soil",
          .equation = "sigma'_v0, sigma'_h0 = (1 - loss) of the cushion's",
          .source = "Yost et al. (2023), section 3; range: transfer measured in chambers",
          .signature = "q_c differs in constant proportion from the top down, in sand; hardly in clay.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::cushion_transfer, &CushionTransfer::loss>(
                              "cushion_transfer.loss_percent", "η_cushion", percent, -50.0, 90.0, any_soil,
                              "share of the cushion's stress that does not reach the soil",
                              "transfer measured in calibration chambers"),
                          -10.0, 40.0}}};
}

}  // namespace cpt::solver

#include "solver/mechanisms/gain_drift.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism gain_drift_mechanism() {
  return {.name = "gain_drift",
          .title = "a load cell whose gain drifts",
          .equation = "q_recorded = q_c (1 + drift z / z_final)",
          .source = "ISO 22476-1 (2012), Table 2: q_c to 5 % of the reading",
          .signature =
              "q_c differs by a share of itself that grows linearly with depth, from nothing at the top.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::gain_drift, &GainDrift::at_end>(
                              "gain_drift.at_end", "δ_end", none, -0.9, 5.0, any_soil,
                              "recorded over true q_c at the final depth, less 1", "ISO 22476-1"),
                          -0.2, 0.2, Prior::accuracy}},
          .of_reading = true};
}

}  // namespace cpt::solver

#include "solver/mechanisms/zero_drift.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism zero_drift_mechanism() {
  return {.name = "zero_drift",
          .title = "a load cell whose zero drifts",
          .equation = "q_recorded = q_c + drift z / z_final",
          .source = "ISO 22476-1 (2012), Table 2: q_c to 100 kPa in application class 2",
          .signature = "q_c differs by kPa that grow linearly with depth, from nothing at the top.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::zero_drift, &ZeroDrift::at_end>(
                              "zero_drift.at_end_kPa", "Δq_end", kilopascals, -5000.0, 5000.0, any_soil,
                              "recorded less true q_c at the final depth", "ISO 22476-1"),
                          -400.0, 400.0, Prior::accuracy}},
          .of_reading = true};
}

}  // namespace cpt::solver

#include "solver/mechanisms/zero_drift.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism zero_drift_mechanism() {
  return {"zero_drift",
          "a load cell whose zero drifts",
          "q_recorded = q_c + drift z / z_final",
          "ISO 22476-1 (2012), Table 2: q_c to 100 kPa in application class 2",
          "q_c differs by kPa that grow linearly with depth, from nothing at the top.",
          any_soil,
          false,
          {{number<&Setup::mechanisms, &Mechanisms::zero_drift, &ZeroDrift::at_end>(
                "zero_drift.at_end_kPa", "Δq_end", kilopascals, -5000.0, 5000.0, any_soil,
                "recorded less true q_c at the final depth", "ISO 22476-1"),
            -100.0, 100.0}},
          true};
}

}  // namespace cpt::solver

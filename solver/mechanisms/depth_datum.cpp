#include "solver/mechanisms/depth_datum.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism depth_datum_mechanism() {
  return {.name = "depth_datum",
          .title = "a shifted depth datum",
          .equation = "recorded depth = true depth + shift",
          .source = "Yost et al. (2023), section 3.3: settlement of the sample",
          .signature = "the whole curve moves up or down: largest differences where q_c changes fastest.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::depth_datum, &DepthDatum::shift>(
                              "depth_datum.shift_mm", "Δz_datum", millimetres, -200.0, 200.0, any_soil,
                              "recorded less true depth", "Yost et al. (2023), section 3.3"),
                          -25.0, 25.0}},
          .of_reading = true};
}

}  // namespace cpt::solver

#include "solver/mechanisms/inclination.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

Mechanism inclination_mechanism() {
  return {
      .name = "inclination",
      .title = "a cone that leaves the vertical",
      .equation = "recorded depth = integral of dz / cos(angle), angle = angle_end z / z_final",
      .source =
          "ISO 22476-1 (2012): depth corrected for the measured inclination; range: a push is ended at 15 "
          "degrees",
      .signature = "the curve is stretched downward, by a length that grows with the cube of the depth.",
      .acts_on = any_soil,
      .parameters =
          {{number<&Setup::mechanisms, &Mechanisms::inclination, &Inclination::at_end>(
                "inclination.at_end_deg", "α_end", degrees, 0.0, 60.0, any_soil,
                "the cone's angle from the vertical at the final depth, growing linearly with depth",
                "ISO 22476-1"),
            0.0, 15.0}},
      .of_reading = true};
}

}  // namespace cpt::solver

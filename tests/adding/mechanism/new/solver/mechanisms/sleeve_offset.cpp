#include "solver/mechanisms/sleeve_offset.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism sleeve_offset_mechanism() {
  return {.name = "sleeve_offset",
          .title = "a sleeve whose zero is off",
          .equation = "f_recorded = f_s + offset",
          .source = "ISO 22476-1 (2012), Table 2: f_s to 15 kPa in application class 2",
          .signature = "none in q_c; f_s differs by the same kPa at all depths.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::sleeve_offset, &SleeveOffset::offset>(
                              "sleeve_offset.offset_kPa", "Δf_0", kilopascals, -500.0, 500.0, any_soil,
                              "recorded less true f_s", "ISO 22476-1"),
                          -15.0, 15.0}},
          .of_reading = true};
}

}  // namespace cpt::solver

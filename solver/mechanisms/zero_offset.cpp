#include "solver/mechanisms/zero_offset.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism zero_offset_mechanism() {
  return {
      .name = "zero_offset",
      .title = "a load cell whose zero is off",
      .equation = "q_recorded = q_c + offset",
      .source = "ISO 22476-1 (2012), Table 2: q_c to 100 kPa in application class 2",
      .signature = "q_c differs by the same kPa at all depths: largest in proportion where the soil is soft.",
      .acts_on = any_soil,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::zero_offset, &ZeroOffset::offset>(
                          "zero_offset.offset_kPa", "Δq_0", kilopascals, -5000.0, 5000.0, any_soil,
                          "recorded less true q_c", "ISO 22476-1"),
                      -400.0, 400.0, Prior::accuracy}},
      .of_reading = true};
}

}  // namespace cpt::solver

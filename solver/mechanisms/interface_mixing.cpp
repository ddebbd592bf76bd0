#include "solver/mechanisms/interface_mixing.hpp"

#include "solver/hashed.hpp"
#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

bool InterfaceMixing::upper_soil(double distance, std::uint64_t id) const {
  return hashed_unit(id) < 0.5 - distance / thickness;
}

Mechanism interface_mixing_mechanism() {
  return {
      .name = "interface_mixing",
      .title = "sand and clay mixed at their interfaces",
      .equation = "share of the upper soil = 1/2 - distance / thickness",
      .source = "sample building; De Lange (2018)",
      .signature = "peaks and troughs next to interfaces are blunter.",
      .acts_on = any_soil,
      .needs_interfaces = 1,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::interface_mixing, &InterfaceMixing::thickness>(
                          "interface_mixing.thickness_mm", "t_mix", millimetres, 0.0, 200.0, any_soil,
                          "thickness of the mixed zone at each interface", "sample building"),
                      0.0, 25.0}}};
}

}  // namespace cpt::solver

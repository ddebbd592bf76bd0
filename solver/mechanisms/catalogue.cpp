#include "solver/mechanisms/catalogue.hpp"

#include <algorithm>
#include <cstddef>
#include <string>

#include "solver/soils/law.hpp"

namespace cpt::solver {

Mechanism surface_compaction_mechanism();
Mechanism density_lens_mechanism();
Mechanism previous_push_mechanism();
Mechanism compliant_wall_mechanism();
Mechanism wall_friction_mechanism();
Mechanism cushion_transfer_mechanism();
Mechanism overconsolidation_mechanism();
Mechanism grain_crushing_mechanism();
Mechanism strain_softening_mechanism();
Mechanism rate_dependence_mechanism();
Mechanism strength_gradient_mechanism();
Mechanism clay_crust_mechanism();
Mechanism depth_datum_mechanism();
Mechanism layer_shift_mechanism();
Mechanism interface_mixing_mechanism();
Mechanism worn_cone_mechanism();
Mechanism zero_offset_mechanism();
Mechanism zero_drift_mechanism();
Mechanism gain_drift_mechanism();
Mechanism sleeve_load_mechanism();
Mechanism inclination_mechanism();
Mechanism layer_thickness_mechanism();
Mechanism density_trend_mechanism();
Mechanism push_speed_mechanism();
Mechanism stress_ratio_trend_mechanism();

std::span<const Mechanism> all_mechanisms() {
  static const std::vector<Mechanism> catalogue = {
      surface_compaction_mechanism(), density_lens_mechanism(),      previous_push_mechanism(),
      compliant_wall_mechanism(),     wall_friction_mechanism(),     cushion_transfer_mechanism(),
      overconsolidation_mechanism(),  grain_crushing_mechanism(),    strain_softening_mechanism(),
      rate_dependence_mechanism(),    strength_gradient_mechanism(), clay_crust_mechanism(),
      depth_datum_mechanism(),        layer_shift_mechanism(),       interface_mixing_mechanism(),
      worn_cone_mechanism(),          zero_offset_mechanism(),       zero_drift_mechanism(),
      gain_drift_mechanism(),         sleeve_load_mechanism(),       inclination_mechanism(),
      layer_thickness_mechanism(),    density_trend_mechanism(),     push_speed_mechanism(),
      stress_ratio_trend_mechanism(),
  };
  return catalogue;
}

const Mechanism* find_mechanism(std::string_view name) {
  for (const Mechanism& mechanism : all_mechanisms())
    if (mechanism.name == name) return &mechanism;
  return nullptr;
}

bool is_mechanism_parameter(std::string_view quantity) {
  return find_mechanism(quantity.substr(0, quantity.find('.'))) != nullptr;
}

bool applies(const Mechanism& mechanism, const Setup& setup) {
  int interfaces = 0;
  for (std::size_t k = 0; k + 1 < setup.layers.size(); ++k)
    if (setup.layers[k].soil != setup.layers[k + 1].soil) ++interfaces;
  if (mechanism.needs_interfaces > 0) return interfaces >= mechanism.needs_interfaces;
  return mechanism.acts_on == nullptr || std::ranges::any_of(setup.layers, [&](const Layer& layer) {
           return mechanism.acts_on(law_of(setup.soils[layer.soil]));
         });
}

bool is_on(const Mechanism& mechanism, const Setup& setup) {
  static const Setup defaults;
  return std::ranges::any_of(mechanism.parameters, [&](const MechanismParameter& parameter) {
    return parameter.quantity.get(setup) != parameter.quantity.get(defaults);
  });
}

}  // namespace cpt::solver

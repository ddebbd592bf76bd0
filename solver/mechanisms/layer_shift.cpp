#include "solver/mechanisms/layer_shift.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

void LayerShift::apply(std::vector<Layer>& layers) const {
  for (std::size_t k = 0; k + 1 < layers.size(); ++k) {
    layers[k].bottom += shift;
    layers[k + 1].top += shift;
  }
}

Mechanism layer_shift_mechanism() {
  return {.name = "layer_shift",
          .title = "layer interfaces that lie elsewhere",
          .equation = "interfaces move down by shift",
          .source = "Yost et al. (2023), section 3.3",
          .signature = "peaks and troughs move with the layers; their height stays.",
          .acts_on = any_soil,
          .needs_interfaces = 1,
          .parameters = {
              {number<&Setup::mechanisms, &Mechanisms::layer_shift, &LayerShift::shift>(
                   "layer_shift.shift_mm", "Δz_layers", millimetres, -100.0, 100.0, any_soil,
                   "how far all interfaces lie below their planned depth", "Yost et al. (2023), section 3.3"),
               -15.0, 15.0}}};
}

}  // namespace cpt::solver

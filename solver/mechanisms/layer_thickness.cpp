#include "solver/mechanisms/layer_thickness.hpp"

#include <cstddef>

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

void LayerThickness::apply(std::vector<Layer>& layers) const {
  if (!on()) return;
  std::vector<std::size_t> above;  // the layers right above interfaces
  for (std::size_t k = 0; k + 1 < layers.size(); ++k)
    if (layers[k].soil != layers[k + 1].soil) above.push_back(k);
  if (above.size() < 2) return;
  const std::size_t upper = (above.size() - 2) / 2;
  const auto move = [&layers](std::size_t k, double down) {
    layers[k].bottom += down;
    layers[k + 1].top += down;
  };
  move(above[upper], -0.5 * change);
  move(above[upper + 1], 0.5 * change);
}

Mechanism layer_thickness_mechanism() {
  return {.name = "layer_thickness",
          .title = "a buried layer of another thickness",
          .equation = "both interfaces of the middle layer move apart by change / 2",
          .source =
              "Yost et al. (2023), section 3.3: depths of interfaces; range: as for interfaces that lie "
              "elsewhere",
          .signature =
              "the peak or trough of the middle layer is wider or narrower, and a thin layer's q_c comes "
              "nearer to its own or stays further from it.",
          .acts_on = any_soil,
          .needs_interfaces = 2,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::layer_thickness, &LayerThickness::change>(
                              "layer_thickness.change_mm", "Δh_layer", millimetres, -200.0, 200.0, any_soil,
                              "thickness of the layer in the middle less the planned one",
                              "Yost et al. (2023), section 3.3"),
                          -15.0, 15.0}}};
}

}  // namespace cpt::solver

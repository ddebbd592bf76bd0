// A buried layer that is thicker or thinner than in the plan, as placing it by mass or by hand leaves it.
//
//   the two interfaces of the layer in the middle move apart by half of `change` each
//
// Of an even number of layers between interfaces it is the upper one of the two in the middle. Layers of the
// same soil that touch count as one. Where soils meet at fewer than two depths nothing moves.
#pragma once

#include <vector>

namespace cpt::solver {

struct Layer;

struct LayerThickness {
  double change = 0.0;  // [m]

  [[nodiscard]] bool on() const { return change != 0.0; }
  void apply(std::vector<Layer>& layers) const;
};

}  // namespace cpt::solver

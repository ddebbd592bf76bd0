// Interfaces that lie elsewhere than in the plan: settlement of the sample while it is built.
//
//   every interface but the soil's top and bottom moves down by `shift`
#pragma once

#include <vector>

namespace cpt::solver {

struct Layer;

struct LayerShift {
  double shift = 0.0;  // [m] downward

  void apply(std::vector<Layer>& layers) const;
};

}  // namespace cpt::solver

// Depths recorded from another zero than the soil's top: settlement under the cushion, a late trigger.
//
//   recorded depth = true depth + shift      Yost et al. (2023), section 3.3
#pragma once

namespace cpt::solver {

struct DepthDatum {
  double shift = 0.0;  // [m]
};

}  // namespace cpt::solver

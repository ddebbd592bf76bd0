// Sand that was under a higher stress before: the initial image pressure lies above the yield surface through
// K0.
//
//   p_i = (1 + excess) p_i(K0 state on its yield surface)
#pragma once

namespace cpt::solver {

struct Overconsolidation {
  double excess = 0.0;  // [-] over-consolidation ratio of the image pressure, less one

  /// Factor on the initial image pressure [-].
  [[nodiscard]] double factor() const { return 1.0 + excess; }
};

}  // namespace cpt::solver

// Sand compacted near its surface, as by a heavy cushion: Yost et al. (2023), section 5.1 and Fig. 9.
//
//   D_r(z) = D_r + increase exp(-z / decay)
//
// The stress stays that of K0: compaction is told by the density alone. The change of the self-weight that
// goes with it (a few per cent over a few centimetres, below 0.1 % of sigma_v0) is left out of the initial
// stress.
#pragma once

#include <cmath>

namespace cpt::solver {

struct SurfaceCompaction {
  double increase = 0.0;  // [-] of the relative density at the soil's top
  double decay = 0.06;    // [m]

  /// Increase of the relative density [-] at a depth [m].
  [[nodiscard]] double at(double depth) const { return increase * std::exp(-depth / decay); }
};

}  // namespace cpt::solver

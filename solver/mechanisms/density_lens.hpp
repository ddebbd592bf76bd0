// A layer of sand that is looser or denser than the rest, as pluviation in stages leaves behind.
//
//   D_r(z) = D_r + change over |z - centre| < thickness / 2
#pragma once

#include <cmath>

namespace cpt::solver {

struct DensityLens {
  double change = 0.0;      // [-] of the relative density
  double centre = 0.25;     // [m] depth
  double thickness = 0.08;  // [m]

  /// Change of the relative density [-] at a depth [m].
  [[nodiscard]] double at(double depth) const {
    return std::abs(depth - centre) < 0.5 * thickness ? change : 0.0;
  }
};

}  // namespace cpt::solver

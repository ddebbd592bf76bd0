// The cone leaves the vertical the deeper the more, and the length of the rods is taken for the depth.
//
//   angle(z) = angle_end z / z_final
//   recorded depth = integral of dz / cos(angle) = asinh(tan(angle(z))) z_final / angle_end
//                                                        ISO 22476-1 (2012): correction of depth for
//                                                        inclination
#pragma once

#include <cmath>

namespace cpt::solver {

struct Inclination {
  double at_end = 0.0;  // [rad] from the vertical, at the final depth

  [[nodiscard]] bool on() const { return at_end != 0.0; }
  /// Length of the rods [m] down to a depth [m].
  [[nodiscard]] double length(double depth, double final_depth) const {
    const double bend = at_end / final_depth;
    return on() ? std::asinh(std::tan(bend * depth)) / bend : depth;
  }
};

}  // namespace cpt::solver

// The inclination of a cone from its two components.
#pragma once

#include <cmath>

namespace cpt::recordings {

/// Angle from the vertical [rad] of an axis that leans by x in one plane and by y in the plane across [rad];
/// NaN if one is. tan^2 = tan^2 x + tan^2 y, for components smaller than a right angle.
[[nodiscard]] inline double resultant(double x, double y) {
  return std::atan(std::hypot(std::tan(x), std::tan(y)));
}

}  // namespace cpt::recordings

#include "solver/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {

Numerics refined(Numerics numerics) {
  const double r = numerics.refinement, points = r * std::sqrt(numerics.point_density);
  numerics.face_elements = static_cast<int>(std::lround(numerics.face_elements * r));
  numerics.near_height /= r;
  numerics.below_height /= r;
  numerics.above_height /= r;
  numerics.far_width /= r;
  numerics.width_growth = std::pow(numerics.width_growth, 1.0 / r);
  for (PointZone& zone : numerics.zones) {
    zone.columns = std::max(1, static_cast<int>(std::lround(zone.columns * points)));
    zone.rows_per_metre *= points;
  }
  numerics.refinement = numerics.point_density = 1.0;
  return numerics;
}

}  // namespace cpt::solver

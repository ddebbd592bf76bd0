#include "solver/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {

Numerics refined(const Setup& setup) {
  Numerics numerics = setup.numerics;
  const double scale = setup.penetrometer.diameter / numerics.for_diameter;
  for (double* length : {&numerics.near_height, &numerics.near_width_radius, &numerics.far_width,
                         &numerics.coarse_rows_radius, &numerics.zone_below, &numerics.zone_above,
                         &numerics.below_height, &numerics.above_height, &numerics.start_distance})
    *length *= scale;
  for (PointZone& zone : numerics.zones) {
    zone.outer_radius *= scale;
    zone.rows_per_metre /= scale;
  }
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

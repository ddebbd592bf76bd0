// How a push changed the void ratio, by distance from the axis.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "results/push/histories.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// Soil between two radii and two depths: means weighted by volume, and the extremes of single points.
struct Ring {
  std::int64_t points = 0;
  double r = 0.0;                                   // [m] mean radius of its points
  double void_ratio_start = 0.0, void_ratio = 0.0;  // [-]
  double void_ratio_min = std::numeric_limits<double>::infinity();
  double void_ratio_max = -std::numeric_limits<double>::infinity();
  [[nodiscard]] double void_ratio_change() const { return void_ratio - void_ratio_start; }
};

/// Rings of this width [m] from the axis outward, of the soil that lies between the two depths at the end;
/// those that hold no material point are left out.
[[nodiscard]] std::vector<Ring> radial_profile(const SoilAtEnd& soil, const DepthInterval& between,
                                               double ring_width);

/// One row a ring: r_m, points, void_ratio_start, void_ratio, void_ratio_change, void_ratio_min,
/// void_ratio_max.
[[nodiscard]] Table ring_table(const std::vector<Ring>& rings);

}  // namespace cpt::results

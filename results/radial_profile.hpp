// How a push changed the void ratio, by distance from the axis.
#pragma once

#include <vector>

#include "results/histories.hpp"
#include "results/table_format.hpp"
#include "solver/point_states.hpp"

namespace cpt::results {

/// Means, weighted by volume, over rings of this width [m]; of the soil that lies between the two depths in
/// the state `now`. One row for each ring that holds a material point: r_m (mean radius of its points),
/// points, void_ratio_start, void_ratio, void_ratio_change, void_ratio_min, void_ratio_max. `start` and `now`
/// hold the same points in the same order.
[[nodiscard]] Table radial_profile(const std::vector<solver::PointState>& start,
                                   const std::vector<solver::PointState>& now, const DepthInterval& between,
                                   double ring_width);

}  // namespace cpt::results

// The soil when the push has ended: where its material points are and what became of their void ratio.
#pragma once

#include <vector>

#include "solver/point_states.hpp"

namespace cpt::results {

/// One value for each material point of the soil, by rising id; empty if the push did not reach its final
/// depth.
struct SoilAtEnd {
  std::vector<double> r, depth;                      // [m] from the axis; below the soil's top
  std::vector<double> volume;                        // [m3] of the ring
  std::vector<double> void_ratio, void_ratio_start;  // [-]
  bool operator==(const SoilAtEnd&) const = default;
};

/// `start` and `end` hold the same points in the same order. Surcharge is left out.
[[nodiscard]] SoilAtEnd soil_at_end(const std::vector<solver::PointState>& start,
                                    const std::vector<solver::PointState>& end);

}  // namespace cpt::results

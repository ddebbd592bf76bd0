#include "results/push/soil_at_end.hpp"

namespace cpt::results {

SoilAtEnd soil_at_end(const std::vector<solver::PointState>& start,
                      const std::vector<solver::PointState>& end) {
  SoilAtEnd soil;
  for (std::size_t k = 0; k < end.size(); ++k) {
    const solver::PointState& point = end[k];
    if (point.surcharge) continue;
    soil.r.push_back(point.r);
    soil.depth.push_back(-point.z);
    soil.volume.push_back(point.volume);
    soil.void_ratio.push_back(point.e);
    soil.void_ratio_start.push_back(start[k].e);
  }
  return soil;
}

}  // namespace cpt::results

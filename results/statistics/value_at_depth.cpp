#include "results/statistics/value_at_depth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cpt::results {

double value_at_depth(const std::vector<double>& depths, const std::vector<double>& values, double depth) {
  if (values.empty() || depth < depths.front() || depth > depths.back())
    return std::numeric_limits<double>::quiet_NaN();
  const auto above = std::ranges::lower_bound(depths, depth);
  const auto k = static_cast<std::size_t>(above - depths.begin());
  if (*above == depth) return values[k];
  return std::lerp(values[k - 1], values[k], (depth - depths[k - 1]) / (depths[k] - depths[k - 1]));
}

}  // namespace cpt::results

#include "results/push/radial_profile.hpp"

#include <algorithm>
#include <map>

namespace cpt::results {

std::vector<Ring> radial_profile(const SoilAtEnd& soil, const DepthInterval& between, double ring_width) {
  struct Sums {
    Ring ring;  // sums weighted by volume, until they are divided by it
    double volume = 0.0;
  };
  std::map<std::int64_t, Sums> by_index;
  for (std::size_t k = 0; k < soil.r.size(); ++k) {
    if (soil.depth[k] < between.from || soil.depth[k] > between.to) continue;
    auto& [ring, volume] = by_index[static_cast<std::int64_t>(soil.r[k] / ring_width)];
    const double e = soil.void_ratio[k];
    ++ring.points;
    volume += soil.volume[k];
    ring.r += soil.r[k] * soil.volume[k];
    ring.void_ratio_start += soil.void_ratio_start[k] * soil.volume[k];
    ring.void_ratio += e * soil.volume[k];
    ring.void_ratio_min = std::min(ring.void_ratio_min, e);
    ring.void_ratio_max = std::max(ring.void_ratio_max, e);
  }
  std::vector<Ring> rings;
  for (auto& [index, sums] : by_index) {
    Ring& ring = rings.emplace_back(sums.ring);
    ring.r /= sums.volume;
    ring.void_ratio_start /= sums.volume;
    ring.void_ratio /= sums.volume;
  }
  return rings;
}

Table ring_table(const std::vector<Ring>& rings) {
  Table table{{"r_m", "points", "void_ratio_start", "void_ratio", "void_ratio_change", "void_ratio_min",
               "void_ratio_max"},
              {}};
  for (const Ring& ring : rings)
    table.rows.push_back({ring.r, ring.points, ring.void_ratio_start, ring.void_ratio,
                          ring.void_ratio_change(), ring.void_ratio_min, ring.void_ratio_max});
  return table;
}

}  // namespace cpt::results

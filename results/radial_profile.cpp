#include "results/radial_profile.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace cpt::results {
namespace {

struct Ring {
  std::int64_t points = 0;
  double volume = 0.0;                     // [m3]
  double r = 0.0, e_start = 0.0, e = 0.0;  // sums weighted by volume
  double e_min = std::numeric_limits<double>::infinity();
  double e_max = -std::numeric_limits<double>::infinity();
};

}  // namespace

Table radial_profile(const std::vector<solver::PointState>& start, const std::vector<solver::PointState>& now,
                     const DepthInterval& between, double ring_width) {
  std::map<std::int64_t, Ring> rings;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const solver::PointState& point = now[k];
    if (point.material == solver::Material::surcharge) continue;
    if (-point.z < between.from || -point.z > between.to) continue;
    Ring& ring = rings[static_cast<std::int64_t>(point.r / ring_width)];
    ++ring.points;
    ring.volume += point.volume;
    ring.r += point.r * point.volume;
    ring.e_start += start[k].e * point.volume;
    ring.e += point.e * point.volume;
    ring.e_min = std::min(ring.e_min, point.e);
    ring.e_max = std::max(ring.e_max, point.e);
  }
  Table table{{"r_m", "points", "void_ratio_start", "void_ratio", "void_ratio_change", "void_ratio_min",
               "void_ratio_max"},
              {}};
  for (const auto& [index, ring] : rings)
    table.rows.push_back({ring.r / ring.volume, ring.points, ring.e_start / ring.volume, ring.e / ring.volume,
                          (ring.e - ring.e_start) / ring.volume, ring.e_min, ring.e_max});
  return table;
}

}  // namespace cpt::results

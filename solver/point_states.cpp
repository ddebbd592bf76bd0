#include "solver/point_states.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace cpt::solver {
namespace {

PointState state_of(const PointFields& p, std::int32_t k, std::int32_t material, bool surcharge) {
  return {static_cast<std::int64_t>(p.id[k]),
          material,
          surcharge,
          p.r[k],
          p.z[k],
          p.v_r[k],
          p.v_z[k],
          p.s_rr[k],
          p.s_zz[k],
          p.s_tt[k],
          p.s_rz[k],
          2.0 * std::numbers::pi * p.volume[k],
          surcharge ? std::numeric_limits<double>::quiet_NaN() : p.e[k],
          p.h_0[k],
          p.h_1[k]};
}

template <typename Function>
void for_each_point(const MaterialPoints& points, const Function& function) {
  for (std::int32_t b = 0; b < points.bucket_count(); ++b) {
    const Bucket& bucket = points.bucket(b);
    if (bucket.count == 0) continue;
    const PointFields fields = points.fields(bucket);
    for (std::int32_t k = 0; k < bucket.count; ++k) function(fields, k, b % points.materials());
  }
}

}  // namespace

std::vector<PointState> point_states(const MaterialPoints& points) {
  std::vector<PointState> states;
  states.reserve(static_cast<std::size_t>(points.size()));
  for_each_point(points, [&](const PointFields& fields, std::int32_t k, std::int32_t material) {
    states.push_back(state_of(fields, k, material, material + 1 == points.materials()));
  });
  std::sort(states.begin(), states.end(),
            [](const PointState& a, const PointState& b) { return a.id < b.id; });
  return states;
}

std::vector<PointState> point_states(const MaterialPoints& points, std::span<const std::int64_t> ids) {
  std::unordered_map<std::int64_t, PointState> found;
  for (const std::int64_t id : ids) found.try_emplace(id);
  for_each_point(points, [&](const PointFields& fields, std::int32_t k, std::int32_t material) {
    const auto place = found.find(static_cast<std::int64_t>(fields.id[k]));
    if (place != found.end())
      place->second = state_of(fields, k, material, material + 1 == points.materials());
  });
  std::vector<PointState> states;
  for (const std::int64_t id : ids)
    if (const PointState& state = found.at(id); state.id == id) states.push_back(state);
  return states;
}

}  // namespace cpt::solver

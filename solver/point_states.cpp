#include "solver/point_states.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace cpt::solver {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

PointState state_of(const PointFields& p, std::int32_t k, Material material) {
  const bool soil = material != Material::surcharge, sand = material == Material::sand;
  return {static_cast<std::int64_t>(p.id[k]),
          material,
          p.r[k],
          p.z[k],
          p.v_r[k],
          p.v_z[k],
          p.s_rr[k],
          p.s_zz[k],
          p.s_tt[k],
          p.s_rz[k],
          2.0 * std::numbers::pi * p.volume[k],
          soil ? p.e[k] : nothing,
          sand ? p.p_i[k] : nothing};
}

template <typename Function>
void for_each_point(const MaterialPoints& points, const Function& function) {
  for (std::int32_t b = 0; b < points.bucket_count(); ++b) {
    const Bucket& bucket = points.bucket(b);
    if (bucket.count == 0) continue;
    const PointFields fields = points.fields(bucket);
    for (std::int32_t k = 0; k < bucket.count; ++k)
      function(fields, k, static_cast<Material>(b % material_count));
  }
}

}  // namespace

std::vector<PointState> point_states(const MaterialPoints& points) {
  std::vector<PointState> states;
  states.reserve(static_cast<std::size_t>(points.size()));
  for_each_point(points, [&](const PointFields& fields, std::int32_t k, Material material) {
    states.push_back(state_of(fields, k, material));
  });
  std::sort(states.begin(), states.end(),
            [](const PointState& a, const PointState& b) { return a.id < b.id; });
  return states;
}

std::vector<PointState> point_states(const MaterialPoints& points, std::span<const std::int64_t> ids) {
  std::unordered_map<std::int64_t, PointState> found;
  for (const std::int64_t id : ids) found.try_emplace(id);
  for_each_point(points, [&](const PointFields& fields, std::int32_t k, Material material) {
    const auto place = found.find(static_cast<std::int64_t>(fields.id[k]));
    if (place != found.end()) place->second = state_of(fields, k, material);
  });
  std::vector<PointState> states;
  for (const std::int64_t id : ids)
    if (const PointState& state = found.at(id); state.id == id) states.push_back(state);
  return states;
}

}  // namespace cpt::solver

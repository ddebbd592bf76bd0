#include "validation/paper/push_measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "validation/paper/published.hpp"

namespace cpt::validation::paper {
namespace {

using results::Histories;
using results::PointHistory;
using results::Ring;

// A number of the push's histories, or why there are none.
Value of(const Push& push, const std::function<Value(const Histories&)>& measure) {
  return push.histories ? measure(*push.histories) : missing_value(push.missing);
}

const PointHistory* point_at(const Histories& push, int radii) {
  for (const PointHistory& point : push.points)
    if (std::abs(point.wanted.r - radii * cone_radius) < 0.1 * cone_radius) return &point;
  return nullptr;
}

// Both paths of the point; `measure` gets p' and q of the first push, then of the second.
using Path = std::vector<double>;
Value of_paths(const Push& first, const Push& second, int radii,
               const std::function<double(const Path&, const Path&, const Path&, const Path&)>& measure) {
  for (const Push* push : {&first, &second})
    if (!push->histories) return missing_value(push->missing);
  const PointHistory* a = point_at(*first.histories, radii);
  const PointHistory* b = point_at(*second.histories, radii);
  if (a == nullptr || b == nullptr)
    return missing_value(fmt::format("no material point at {} cone radii was followed", radii));
  return {measure(a->columns.at("p").values, a->columns.at("q").values, b->columns.at("p").values,
                  b->columns.at("q").values),
          {}};
}

double mean(const Path& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

Value of_rings(const Push& push, const std::function<double(const std::vector<Ring>&)>& measure) {
  return of(push, [&](const Histories& histories) {
    const std::vector<Ring> rings = void_ratio_rings(histories);
    return rings.empty() ? missing_value("no soil between the depths") : Value{measure(rings), {}};
  });
}

double least_change(const std::vector<Ring>& rings) {
  double least = std::numeric_limits<double>::infinity();
  for (const Ring& ring : rings) least = std::min(least, ring.void_ratio_change());
  return least;
}

}  // namespace

Value path_distance(const Push& first, const Push& second, int radii) {
  return of_paths(first, second, radii, [](const Path& p1, const Path& q1, const Path& p2, const Path& q2) {
    double apart = 0.0, size = 0.0;
    for (std::size_t i = 0; i < std::min(p1.size(), p2.size()); ++i) {
      apart += std::hypot(p2[i] - p1[i], q2[i] - q1[i]);
      size += std::hypot(p1[i], q1[i]);
    }
    return apart / size;
  });
}

Value mean_stress_change(const Push& first, const Push& second, int radii) {
  return of_paths(first, second, radii, [](const Path& p1, const Path&, const Path& p2, const Path&) {
    return mean(p2) / mean(p1) - 1.0;
  });
}

Value largest_wall_rise(const Push& push, std::string_view stress) {
  return of(push, [&](const Histories& histories) {
    if (histories.walls.empty()) return missing_value("no part of the wall was followed");
    double largest = -1.0;
    for (const results::WallHistory& wall : histories.walls) {
      const std::vector<double>& values = wall.columns.at(std::string(stress)).values;
      largest = std::max(largest, *std::max_element(values.begin(), values.end()) / values.front() - 1.0);
    }
    return Value{largest, {}};
  });
}

Value final_wall_ratio(const Push& push) {
  return of(push, [](const Histories& histories) {
    if (histories.walls.empty()) return missing_value("no part of the wall was followed");
    double sum = 0.0;
    for (const results::WallHistory& wall : histories.walls)
      sum += wall.columns.at("sigma_r").values.back() / wall.columns.at("sigma_v").values.back();
    return Value{sum / static_cast<double>(histories.walls.size()), {}};
  });
}

results::DepthInterval middle_half(const Histories& push) {
  const double final_depth = push.tip_depth.back();
  return {0.25 * final_depth, 0.75 * final_depth};
}

std::vector<Ring> void_ratio_rings(const Histories& push) {
  return results::radial_profile(push.end, middle_half(push), 0.2 * cone_radius);
}

Value altered_radius(const Push& push) {
  return of_rings(push, [](const std::vector<Ring>& rings) {
    const double bound = altered_part * std::abs(least_change(rings));
    double radius = 0.0;
    for (const Ring& ring : rings)
      if (std::abs(ring.void_ratio_change()) > bound) radius = ring.r;
    return radius;
  });
}

Value change_beside_cone(const Push& push) {
  return of_rings(push, [](const std::vector<Ring>& rings) { return rings.front().void_ratio_change(); });
}

Value largest_contraction(const Push& push) { return of_rings(push, least_change); }

Value least_ring_void_ratio(const Push& push) {
  return of_rings(push, [](const std::vector<Ring>& rings) {
    double least = std::numeric_limits<double>::infinity();
    for (const Ring& ring : rings) least = std::min(least, ring.void_ratio);
    return least;
  });
}

Value least_point_void_ratio(const Push& push) {
  return of(push, [](const Histories& histories) {
    const std::vector<double>& e = histories.end.void_ratio;
    return e.empty() ? missing_value("the push did not get to its end")
                     : Value{*std::min_element(e.begin(), e.end()), {}};
  });
}

}  // namespace cpt::validation::paper

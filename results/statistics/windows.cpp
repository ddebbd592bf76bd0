#include "results/statistics/windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace cpt::results {
namespace {

constexpr double on_edge = 1.0e-9;  // [m] a bin centre this near to an interval's end lies in it

bool inside(double depth, double from, double to) { return depth >= from - on_edge && depth <= to + on_edge; }

}  // namespace

Resolved<Interval> resolve_window(const parameters::Window& window, const solver::DepthProfile& baseline) {
  using Kind = parameters::Window::Kind;
  if (window.kind == Kind::fixed || window.kind == Kind::scalar) return {{window.from, window.to}, ""};
  const double sign = window.kind == Kind::peak ? 1.0 : -1.0;
  const std::string_view extreme = window.kind == Kind::peak ? "peak" : "trough";
  double best = -std::numeric_limits<double>::infinity();
  double first = std::numeric_limits<double>::quiet_NaN(), last = first, centre = first;
  for (std::size_t i = 0; i < baseline.depth.size(); ++i) {
    const double depth = baseline.depth[i];
    if (!inside(depth, window.from, window.to) || !std::isfinite(baseline.q_c[i])) continue;
    if (std::isnan(first)) first = depth;
    last = depth;
    if (sign * baseline.q_c[i] > best) {
      best = sign * baseline.q_c[i];
      centre = depth;
    }
  }
  if (std::isnan(centre))
    return {{},
            fmt::format("the baseline has no q_c between {} and {} m, where the {} of window {} is sought",
                        window.from, window.to, extreme, window.name)};
  // There q_c still rises or falls beyond the range, or does not vary: it has no extreme to stand on.
  if (centre == first || centre == last)
    return {
        {},
        fmt::format("the baseline has no {} between {} and {} m: its {} q_c there lies at the {} end of the "
                    "range, {:.6g} m; widen between_m of window {} past the {}",
                    extreme, window.from, window.to, window.kind == Kind::peak ? "largest" : "least",
                    centre == first ? "upper" : "lower", centre, window.name, extreme)};
  return {{centre - 0.5 * window.width, centre + 0.5 * window.width}, ""};
}

Resolved<WindowMean> average(const solver::DepthProfile& profile, const Interval& interval) {
  double sum = 0.0;
  WindowMean mean{0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < profile.depth.size(); ++i) {
    const double q_c = profile.q_c[i];
    if (!inside(profile.depth[i], interval.from, interval.to) || !std::isfinite(q_c)) continue;
    sum += q_c;
    mean.min = std::min(mean.min, q_c);
    mean.max = std::max(mean.max, q_c);
    ++mean.bins;
  }
  if (mean.bins == 0)
    return {{},
            fmt::format("no depth bin of q_c lies between {:.6g} and {:.6g} m", interval.from, interval.to)};
  mean.mean = sum / mean.bins;
  return {mean, ""};
}

Resolved<WindowMean> average(const solver::ProgramResult& result, const Interval& interval) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (result.x.empty()) return {{result.y.front(), none, none, 1}, ""};
  double sum = 0.0;
  WindowMean mean{0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < result.x.size(); ++i) {
    if (result.x[i] < interval.from || result.x[i] > interval.to) continue;
    sum += result.y[i];
    mean.min = std::min(mean.min, result.y[i]);
    mean.max = std::max(mean.max, result.y[i]);
    ++mean.bins;
  }
  if (mean.bins == 0)
    return {{}, fmt::format("{} has no value between {} and {}", result.name, interval.from, interval.to)};
  mean.mean = sum / mean.bins;
  return {mean, ""};
}

double channel_average(const solver::DepthProfile& profile, const solver::Channel& channel,
                       const Interval& interval) {
  const std::vector<double>& values = profile.*channel.values;
  double sum = 0.0;
  int bins = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (inside(profile.depth[i], interval.from, interval.to) && std::isfinite(values[i]))
      sum += values[i], ++bins;
  return bins > 0 ? sum / bins : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace cpt::results

#include "results/statistics/window_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "results/statistics/repeat_noise.hpp"

namespace cpt::results {
namespace {

constexpr std::size_t most_windows = 10;
constexpr std::size_t fewest_windows = 6;
constexpr int fewest_bins = 2;  // in a window

struct Average {
  double depth;  // [m] mean of the window's bins
  double q_c;    // [Pa]
};

std::vector<Average> averages_around(const solver::DepthProfile& profile, const Interval& interval) {
  const double width = interval.to - interval.from;
  const solver::DepthProfile depths{profile.depth, profile.depth, {}, {}};
  std::vector<Average> found;
  const auto try_at = [&](int shift) {
    const Interval here = {interval.from + shift * width, interval.to + shift * width};
    if (found.size() >= most_windows || here.from < 0.0 || here.to > profile.depth.back() + 0.5 * width)
      return;
    // Open at the upper end, so that no bin counts in two windows.
    const Interval open = {here.from + 1e-3 * width, here.to};
    const auto mean = average(profile, open);
    if (mean && mean.value.bins >= fewest_bins)
      found.push_back({average(depths, open).value.mean, mean.value.mean});
  };
  try_at(0);
  const int reach = width > 0.0 ? static_cast<int>(most_windows) : 0;
  for (int shift = 1; shift <= reach; ++shift) {
    try_at(-shift);
    try_at(shift);
  }
  return found;
}

}  // namespace

std::optional<WindowNoise> window_noise(const solver::DepthProfile& profile, const Interval& interval) {
  if (profile.depth.empty() || !(interval.to > interval.from)) return std::nullopt;
  const std::vector<Average> averages = averages_around(profile, interval);
  if (averages.size() < fewest_windows) return std::nullopt;

  const auto n = static_cast<double>(averages.size());
  double depth = 0.0, q_c = 0.0;
  for (const Average& a : averages) {
    depth += a.depth / n;
    q_c += a.q_c / n;
  }
  double zz = 0.0, zq = 0.0;
  for (const Average& a : averages) {
    zz += (a.depth - depth) * (a.depth - depth);
    zq += (a.depth - depth) * (a.q_c - q_c);
  }
  const double slope = zq / zz;
  double rest = 0.0;
  for (const Average& a : averages) rest += std::pow(a.q_c - q_c - slope * (a.depth - depth), 2);
  const int freedom = static_cast<int>(averages.size()) - 2;
  return WindowNoise{std::sqrt(rest / freedom), freedom};
}

double index_uncertainty(double q_lower, const WindowNoise& lower, double q_upper, const WindowNoise& upper) {
  const double a = lower.deviation / q_upper;
  const double b = q_lower * upper.deviation / (q_upper * q_upper);
  const double variance = a * a + b * b;
  if (!(variance > 0.0)) return 0.0;
  const double freedom =
      variance * variance / (a * a * a * a / lower.freedom + b * b * b * b / upper.freedom);  // Welch (1947)
  return student_t(freedom) * std::sqrt(variance);
}

}  // namespace cpt::results

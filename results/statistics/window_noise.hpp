// How far chance moves a window's average q_c, and with it a sensitivity index.
//
// SI_noise (sensitivity.hpp) is the spread of q_c inside one window. An average over the window moves less
// than that. By how much is told by the same curve: windows of the same width, side by side, above and below
// the one asked about, have averages that follow the trend with depth but for the noise (the method of batch
// means).
#pragma once

#include <optional>

#include "results/statistics/windows.hpp"

namespace cpt::results {

struct WindowNoise {
  double deviation;  // [Pa] standard deviation of one window's average about a straight trend with depth
  int freedom;       // [-] degrees of freedom of that estimate
};

/// From the averages of up to ten windows of equal width, the one at `interval` and its neighbours on the
/// curve, nearest first. nullopt if there are fewer than six. It is meant for curves with one trend over
/// these windows: a homogeneous soil, well below its top. It sees noise up to the length of the windows
/// together and no longer; what the model does alike at all depths it cannot see.
[[nodiscard]] std::optional<WindowNoise> window_noise(const solver::DepthProfile& profile,
                                                      const Interval& interval);

/// Half width [-] of the 95 % confidence interval of SI = (q_upper - q_lower) / q_upper, to first order in
/// the deviations of both averages, which are taken as independent, with Student's t for the fewer degrees of
/// freedom. Averages in any one unit, deviations in the same. Wants q_upper > 0.
[[nodiscard]] double index_uncertainty(double q_lower, const WindowNoise& lower, double q_upper,
                                       const WindowNoise& upper);

}  // namespace cpt::results

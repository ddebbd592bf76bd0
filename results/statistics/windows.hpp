// Depth windows: where they lie and what q_c is inside (Yost et al. 2023, section 5.1).
#pragma once

#include <string>

#include "parameters/study.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

/// A window's resolved interval, both ends included.
struct Interval {
  double from;  // [m]
  double to;    // [m]
};

/// Mean, least and largest q_c over the bins whose centre lies in an interval.
struct WindowMean {
  double mean, min, max;  // [Pa]
  int bins;
};

/// A value, or the reason why there is none.
template <class T>
struct Resolved {
  T value{};
  std::string problem;  ///< empty if there is a value
  explicit operator bool() const { return problem.empty(); }
};

/// A fixed window is its interval. A peak (trough) window is centred on the bin with the largest (least) q_c
/// of the baseline's curve between its `from` and `to`; the shallowest such bin if several tie. Bins whose
/// q_c is not finite do not count. The first or the last bin of the range is no extreme: a problem.
[[nodiscard]] Resolved<Interval> resolve_window(const parameters::Window& window,
                                                const solver::DepthProfile& baseline);

/// Averages the bins with centres in [from, to], in order of depth.
[[nodiscard]] Resolved<WindowMean> average(const solver::DepthProfile& profile, const Interval& interval);

/// The same of what an external program gave, in its unit: the ordinates whose abscissas lie in the interval.
/// A scalar is its own mean, without a least and a largest value (NaN).
[[nodiscard]] Resolved<WindowMean> average(const solver::ProgramResult& result, const Interval& interval);

/// Mean [Pa] of a channel over the same bins; NaN where it was not recorded there.
[[nodiscard]] double channel_average(const solver::DepthProfile& profile, const solver::Channel& channel,
                                     const Interval& interval);

}  // namespace cpt::results

// How fast the cone was pushed, and where that was not the standard speed.
#pragma once

#include <vector>

#include "recordings/recording.hpp"

namespace cpt::recordings {

// ISO 22476-1: the speed of penetration is 20 mm/s +- 5 mm/s.
inline constexpr double slowest_standard_speed = 0.015;  // [m/s]
inline constexpr double fastest_standard_speed = 0.025;  // [m/s]

enum class SpeedSource { none, recorded, from_time };

struct PushSpeed {
  SpeedSource source = SpeedSource::none;
  std::vector<double> speed;  // [m/s] for each reading; NaN where unknown
};

/// The file's own speed, else distance over time across 0.05 m above and below a reading. Unknown behind a
/// stop and where the push stands: no way, or no time, within that reach.
[[nodiscard]] PushSpeed push_speed(const Recording& recording);

/// A run of readings outside of the standard speed.
struct OddSpeed {
  double from = 0.0, to = 0.0;  // [m] depths of its first and last reading
  int readings = 0;
  double min = 0.0, median = 0.0, max = 0.0;  // [m/s]
};
/// Runs of readings, in order of depth; readings of unknown speed in between do not end one.
[[nodiscard]] std::vector<OddSpeed> odd_speeds(const Recording& recording, const PushSpeed& speed);

}  // namespace cpt::recordings

#include "recordings/push_speed.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::recordings {
namespace {

constexpr double reach = 0.05;             // [m] above and below a reading, or more for a coarse clock
constexpr double enough_steps = 20.0;      // [-] steps of the clock, for 5 % of the speed
constexpr double least_steps = 8.0;        // [-] steps of the clock
constexpr std::size_t most = 200;          // readings above and below
constexpr double least_reach = 1e-6;       // [m]
constexpr double rounding = 1e-5;          // [m/s]
constexpr double standing_speed = 0.5e-3;  // [m/s] less is the end of a push, not its speed

double along(const Reading& reading) { return std::isnan(reading.length) ? reading.depth : reading.length; }

/// The step in which a file's clock counts [s]: the largest of 1 s to 1 ms of which all times are multiples.
double step_of_clock(const std::vector<Reading>& readings) {
  for (const double step : {1.0, 0.1, 0.01}) {
    const bool all = std::all_of(readings.begin(), readings.end(), [&](const Reading& reading) {
      const double steps = reading.time / step;
      return std::isnan(steps) || std::abs(steps - std::round(steps)) < 1e-4;
    });
    if (all) return step;
  }
  return 1e-3;
}

/// Distance over time of the readings around one that no stop parts from it.
double speed_around(const std::vector<Reading>& readings, std::size_t at, double clock) {
  std::size_t first = at, last = at;
  const auto time = [&] { return readings[last].time - readings[first].time; };
  const auto wanted = [&](std::size_t i) {
    return !std::isnan(readings[i].time) &&
           (std::abs(readings[i].depth - readings[at].depth) <= reach || time() < enough_steps * clock);
  };
  for (bool grows = true; grows;) {
    grows = false;
    if (first > 0 && at - first < most && !readings[first].after_stop && wanted(first - 1)) {
      --first;
      grows = true;
    }
    if (last + 1 < readings.size() && last - at < most && !readings[last + 1].after_stop &&
        wanted(last + 1)) {
      ++last;
      grows = true;
    }
  }
  const double length = along(readings[last]) - along(readings[first]);
  return time() >= least_steps * clock && length > least_reach ? length / time() : not_given;
}

}  // namespace

PushSpeed push_speed(const Recording& recording) {
  PushSpeed result;
  const std::vector<Reading>& readings = recording.readings;
  result.speed.assign(readings.size(), not_given);
  if (has(recording, &Reading::speed))
    result.source = SpeedSource::recorded;
  else if (has(recording, &Reading::time))
    result.source = SpeedSource::from_time;
  else
    return result;
  const double clock = step_of_clock(readings);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double speed = result.source == SpeedSource::recorded ? readings[i].speed
                         : std::isnan(readings[i].time)         ? not_given
                                                                : speed_around(readings, i, clock);
    const bool starts = readings[i].after_stop && result.source == SpeedSource::recorded;
    if (!starts && std::abs(speed) >= standing_speed) result.speed[i] = speed;
  }
  return result;
}

std::vector<OddSpeed> odd_speeds(const Recording& recording, const PushSpeed& speed) {
  std::vector<OddSpeed> runs;
  std::vector<double> of_run;
  const auto finish = [&] {
    if (of_run.empty()) return;
    const Spread s = spread(of_run);
    runs.back().readings = s.values;
    runs.back().min = s.min;
    runs.back().median = s.median;
    runs.back().max = s.max;
    of_run.clear();
  };
  for (std::size_t i = 0; i < speed.speed.size(); ++i) {
    const double v = speed.speed[i];
    if (std::isnan(v)) continue;
    if (v >= slowest_standard_speed - rounding && v <= fastest_standard_speed + rounding) {
      finish();
      continue;
    }
    if (of_run.empty()) runs.push_back({recording.readings[i].depth, 0.0, 0, 0.0, 0.0, 0.0});
    runs.back().to = recording.readings[i].depth;
    of_run.push_back(v);
  }
  finish();
  return runs;
}

}  // namespace cpt::recordings

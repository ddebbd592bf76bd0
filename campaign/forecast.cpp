#include "campaign/forecast.hpp"

#include <algorithm>

namespace cpt::campaign {
namespace {

constexpr double rate_window = 20.0;             // [s]
constexpr double least_telling_fraction = 0.05;  // below, elapsed / fraction says little

}  // namespace

void Forecast::started(int realization, int threads, double now) {
  running_[realization] = {now, threads};
  sample(now);
}

void Forecast::progressed(int realization, double fraction, double point_steps, double now) {
  const auto found = running_.find(realization);
  if (found == running_.end()) return;
  found->second.fraction = std::clamp(fraction, 0.0, 1.0);
  total_point_steps_ += std::max(point_steps - found->second.point_steps, 0.0);
  found->second.point_steps = point_steps;
  sample(now);
}

void Forecast::ended(int realization, bool completed, double point_steps, double now) {
  const auto found = running_.find(realization);
  if (found == running_.end()) return;
  progressed(realization, 1.0, std::max(point_steps, found->second.point_steps), now);
  if (completed) {
    finished_core_seconds_ += (now - found->second.since) * found->second.threads;
    ++finished_;
  }
  running_.erase(found);
}

void Forecast::restarted(int realization) { running_.erase(realization); }

std::optional<double> Forecast::core_seconds_each(double now) const {
  double sum = finished_core_seconds_;
  double count = finished_;
  // A running realization counts by the share it has done, so the estimate exists before the first has
  // finished.
  for (const auto& [id, running] : running_) {
    if (running.fraction < least_telling_fraction) continue;
    sum += (now - running.since) * running.threads;
    count += running.fraction;
  }
  if (count <= 0.0) return std::nullopt;
  return sum / count;
}

std::optional<double> Forecast::remaining_seconds(int pending, int slots, double now) const {
  if (pending == 0 && running_.empty()) return 0.0;
  const std::optional<double> each = core_seconds_each(now);
  if (!each || slots <= 0) return std::nullopt;
  double work = pending * *each;
  double longest = 0.0;
  for (const auto& [id, running] : running_) {
    const double elapsed = now - running.since;
    const double rest = running.fraction >= least_telling_fraction
                            ? elapsed * (1.0 - running.fraction) / running.fraction
                            : std::max(*each / running.threads - elapsed, 0.0);
    work += rest * running.threads;
    longest = std::max(longest, rest);
  }
  return std::max(work / slots, longest);
}

double Forecast::point_steps_per_second(double now) const {
  if (samples_.size() < 2) return 0.0;
  const double span = now - samples_.front().time;
  return span > 0.0 ? (total_point_steps_ - samples_.front().point_steps) / span : 0.0;
}

void Forecast::sample(double now) {
  samples_.push_back({now, total_point_steps_});
  while (samples_.size() > 2 && samples_.front().time < now - rate_window) samples_.pop_front();
}

}  // namespace cpt::campaign

#include "solver/push_watch.hpp"

#include <fmt/format.h>

namespace cpt::solver {
namespace {

constexpr int steps_between_looks = 8;
constexpr double seconds_between_reports = 0.1;

}  // namespace

PushWatch::PushWatch(Observer& observer, const Execution& execution, double final_depth,
                     double earlier_seconds)
    : observer_(observer),
      execution_(execution),
      final_depth_(final_depth),
      earlier_seconds_(earlier_seconds) {}

double PushWatch::wall_seconds() const {
  return earlier_seconds_ + std::chrono::duration<double>(Clock::now() - start_).count();
}

void PushWatch::after_step(double depth, Outcome& outcome, const std::function<PushState()>& state) {
  if (outcome.steps < next_look_ || outcome.status != Status::completed) return;
  next_look_ = outcome.steps + steps_between_looks;
  const double now = wall_seconds();
  if (now > execution_.wall_limit_seconds) {
    outcome.status = Status::time_limit;
    outcome.reason = fmt::format("wall time limit of {:.0f} s reached at {:.1f} mm depth",
                                 execution_.wall_limit_seconds, depth * 1e3);
  } else if (now - last_report_ > seconds_between_reports) {
    last_report_ = now;
    observer_.progress({depth, final_depth_, outcome.steps, outcome.material_points, now});
    if (observer_.stop_requested(outcome.reason)) outcome.status = Status::time_limit;
    if (observer_.state_wanted()) observer_.keep_state(state());
  }
}

}  // namespace cpt::solver

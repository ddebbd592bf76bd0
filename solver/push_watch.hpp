// The eyes on a push that change no bit of it: the clock's limit, progress, requests to stop and for its
// state.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>

#include "solver/simulate.hpp"

namespace cpt::solver {

class PushWatch {
 public:
  /// Both are to outlive it. `earlier_seconds` were spent on the pushes before.
  PushWatch(Observer& observer, const Execution& execution, double final_depth, double earlier_seconds);

  /// [s] of this push and those before, pauses left out.
  [[nodiscard]] double wall_seconds() const;
  /// A push that is resumed had spent so many seconds, those before it included.
  void go_on_from(double seconds) { earlier_seconds_ = seconds; }

  /// After steps; looks at the clock now and then, and may end the push. `state` makes what is to be
  /// kept.
  void after_step(double depth, Outcome& outcome, const std::function<PushState()>& state);

 private:
  using Clock = std::chrono::steady_clock;
  Observer& observer_;
  const Execution& execution_;
  double final_depth_, earlier_seconds_;
  double last_report_ = -std::numeric_limits<double>::infinity();  // the first one is due at once
  std::int64_t next_look_ = 0;                                     // [-] steps
  Clock::time_point start_ = Clock::now();
};

}  // namespace cpt::solver

// The one clock of the campaign's processes; everything else takes the time as an argument.
#pragma once

#include <chrono>
#include <ctime>

namespace cpt::campaign {

/// [s] since some fixed moment; never steps back.
[[nodiscard]] inline double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// [s] that this thread has had a core.
[[nodiscard]] inline double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace cpt::campaign

// The one clock of the campaign's processes; everything else takes the time as an argument.
#pragma once

#include <chrono>

namespace cpt::campaign {

/// [s] since some fixed moment; never steps back.
[[nodiscard]] inline double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace cpt::campaign

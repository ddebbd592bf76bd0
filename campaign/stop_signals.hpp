// SIGINT, SIGTERM, SIGHUP and SIGUSR1 (a batch system's warning) ask the campaign to stop cleanly.
#pragma once

#include <signal.h>

namespace cpt::campaign {

inline constexpr int stop_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGUSR1};

/// Catches these signals for as long as it lives; a second one within a stop changes nothing. At most one at
/// a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  /// The signal that arrived, 0 if none has.
  [[nodiscard]] static int received();
};

}  // namespace cpt::campaign

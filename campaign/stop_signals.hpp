// SIGINT, SIGTERM and SIGHUP ask the campaign to stop cleanly.
#pragma once

namespace cpt::campaign {

/// Catches the three signals for as long as it lives; a second one within a stop changes nothing. Also
/// ignores SIGPIPE. At most one at a time.
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

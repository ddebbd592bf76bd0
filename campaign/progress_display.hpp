// The campaign's progress on the terminal, or as plain lines where there is none.
#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "campaign/scheduler.hpp"

namespace cpt::campaign {

/// "45 s", "4 min 10 s", "2 h 05 min".
[[nodiscard]] std::string format_duration(double seconds);

/// What a progress line says.
struct Standing {
  Tally tally;
  std::optional<double> remaining_seconds;  ///< unknown at first
  double point_steps_per_second = 0.0;      ///< [1/s] material-point steps
};

/// "12/21 done, 2 running, 1 failed, ETA 4 min 10 s, 13.2 million material-point steps/s". Done includes
/// failed.
[[nodiscard]] std::string progress_line(const Standing& standing);

/// On a terminal one line is rewritten twice a second, under the lasting lines; elsewhere a plain line every
/// ten seconds.
class ProgressDisplay {
 public:
  enum class Style { terminal, plain, silent };
  ProgressDisplay(std::FILE* out, Style style) : out_(out), style_(style) {}
  /// terminal or plain, as the stream is one.
  [[nodiscard]] static Style style_of(std::FILE* out);

  /// A line that stays.
  void note(std::string_view line);
  /// The line that changes; `now` [s] of any clock. More frequent calls are passed over.
  void update(std::string line, double now);
  void update(const Standing& standing, double now) { update(progress_line(standing), now); }
  /// Ends the updating line.
  void finish();

 private:
  void erase_line();
  std::FILE* out_;
  Style style_;
  std::string shown_;
  std::optional<double> last_update_;
};

}  // namespace cpt::campaign

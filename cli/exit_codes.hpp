// What the program's exit code says: the one list, which --help, the man page and docs/reference.md print and
// README.md repeats (a test compares them).
#pragma once

#include <span>
#include <string>

namespace cpt::cli {

enum ExitCode : int {
  all_well = 0,
  realizations_failed = 1,
  bad_input = 2,
  database_in_use = 3,
  rerun_differs = 4,
  internal_error = 5,
  unusable_file = 6,
  emulator_refused = 7,
  stopped_by_signal = 128,  ///< plus the signal's number
};

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};
[[nodiscard]] std::span<const ExitMeaning> exit_meanings();

/// "0" ..., "128 + n"
[[nodiscard]] std::string to_string(ExitCode code);

/// The list for the end of --help, without a line end at its own end.
extern const std::string exit_code_help;

}  // namespace cpt::cli

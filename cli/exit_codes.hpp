// What the program's exit code says. README.md and `campaign --help` show the same list.
#pragma once

namespace cpt::cli {

enum ExitCode : int {
  all_well = 0,  ///< done; every realization is completed
  realizations_failed =
      1,          ///< the campaign is finished, but some realizations failed; `query failures` tells why
  bad_input = 2,  ///< the command line or the study is wrong; nothing was run
  database_in_use = 3,  ///< another campaign is running on the same database
  rerun_differs = 4,    ///< the realization run again gave another outcome than the stored one
  internal_error = 5,   ///< a fault of the program
  unusable_file = 6,    ///< a database, curve or report file cannot be read or written
  stopped_by_signal =
      128,  ///< plus the signal's number: 130 Ctrl-C, 143 terminated; the same command goes on
};

inline constexpr const char* exit_code_help = R"(Exit codes:
  0  done; every realization is completed
  1  the campaign is finished, but some realizations failed (campaign query STUDY failures tells why)
  2  the command line or the study is wrong; nothing was run
  3  another campaign is running on the same database
  4  rerun gave another outcome than the stored one
  5  internal error
  6  a database, curve or report file cannot be read or written
  128 + n  stopped by signal n (130 Ctrl-C, 138 SIGUSR1, 143 terminated); the same command goes on where it stopped)";

}  // namespace cpt::cli

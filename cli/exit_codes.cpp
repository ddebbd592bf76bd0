#include "cli/exit_codes.hpp"

#include <fmt/format.h>

namespace cpt::cli {
namespace {

constexpr ExitMeaning all_meanings[] = {
    {all_well, "done; every realization is completed"},
    {realizations_failed,
     "the campaign is finished, but some realizations failed: campaign query STUDY failures tells why"},
    {bad_input, "the command line or the study is wrong; nothing was run"},
    {database_in_use, "another campaign is running on the same database"},
    {rerun_differs, "rerun gave another outcome than the stored one"},
    {internal_error, "internal error"},
    {unusable_file,
     "a database, curve or report file cannot be read or written, or standard output is full, closed or read "
     "no further, as by head, that of mpirun included where it runs on the same machine"},
    {emulator_refused,
     "an emulator misses more than a tenth of an output's variance at held-out runs (Q2 < 0.9)"},
    {stopped_by_signal,
     "stopped by signal n (130 Ctrl-C, 138 SIGUSR1, 143 terminated); the same command goes on where it "
     "stopped"},
};

std::string help() {
  std::string text = "Exit codes:";
  for (const ExitMeaning& exit : all_meanings)
    text += fmt::format("\n  {}  {}", to_string(exit.code), exit.meaning);
  return text;
}

}  // namespace

std::span<const ExitMeaning> exit_meanings() { return all_meanings; }

std::string to_string(ExitCode code) {
  return code == stopped_by_signal ? "128 + n" : std::to_string(static_cast<int>(code));
}

const std::string exit_code_help = help();

}  // namespace cpt::cli

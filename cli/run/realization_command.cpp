#include "cli/run/realization_command.hpp"

#include <CLI/CLI.hpp>

namespace cpt::cli {

void add_executor_option(CLI::App& command, std::string& executor) {
  command.add_option("--executor", executor)->group("");  // no group: not in --help
}

std::vector<std::string> realization_command(const std::string& executor) {
  // The link holds even if the program's file is replaced while the campaign runs.
  if (executor.empty()) return {"/proc/self/exe", "realize"};
  return {executor};
}

}  // namespace cpt::cli

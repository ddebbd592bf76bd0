#include "cli/run/realization_command.hpp"

#include <CLI/CLI.hpp>

namespace cpt::cli {

void add_executor_option(CLI::App& command, std::string& executor) {
  command.add_option("--executor", executor)->group("");  // no group: not in --help
}

campaign::RealizationCommand realization_command(const std::string& executor) {
  if (executor.empty()) return campaign::own_realization_command();
  return {{executor}, {executor}};
}

}  // namespace cpt::cli

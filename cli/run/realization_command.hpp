// How the process of one realization is started.
#pragma once

#include <string>

#include "campaign/realization_command.hpp"

namespace CLI {
class App;
}

namespace cpt::cli {

/// Hidden option --executor PROGRAM: what runs a realization in place of this program, for tests.
void add_executor_option(CLI::App& command, std::string& executor);

/// This program started anew, or the given executor; of another program's realizations the small one beside
/// this.
[[nodiscard]] campaign::RealizationCommand realization_command(const std::string& executor);

}  // namespace cpt::cli

// How the process of one realization is started.
#pragma once

#include <string>
#include <vector>

namespace cpt::campaign {

/// Absolute path and arguments of a process that serves one order (order_server.hpp).
struct RealizationCommand {
  std::vector<std::string> push;     ///< of the embedded solver: realization_child.hpp
  std::vector<std::string> program;  ///< of another program: external/program_main.cpp, or the same as `push`
};

/// This program started anew, and for other programs' realizations campaign-program: beside this program in a
/// build, under lib in an installation; where it is not, as if the program was copied alone, this program,
/// too.
[[nodiscard]] RealizationCommand own_realization_command();

}  // namespace cpt::campaign

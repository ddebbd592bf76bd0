// Completion of the command line by the shell.
#pragma once

#include <string>

#include "cli/program/command_tree.hpp"

namespace cpt::cli {

/// A script for bash, which zsh's bashcompinit reads too: subcommands, options, listed values, names of
/// quantities, files where a file is meant.
[[nodiscard]] std::string bash_completion(const CommandEntry& program);

}  // namespace cpt::cli

// The reference: commands and every list of the program, written from the code alone.
#pragma once

#include <string>

#include "cli/program/command_tree.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::cli {

/// docs/reference.md
[[nodiscard]] std::string reference_page(const CommandEntry& program);
/// The man page campaign(1), in roff with man(7)'s macros.
[[nodiscard]] std::string man_page(const CommandEntry& program);

/// The footer of a command without the list of exit codes, which both pages have once.
[[nodiscard]] std::string own_footer(const CommandEntry& command);
/// What --help says of the option, then its choices or range where the words do not name them.
[[nodiscard]] std::string full_meaning(const OptionEntry& option);
/// A cell as text, numbers in full.
[[nodiscard]] std::string text_of(const results::Cell& cell);

}  // namespace cpt::cli

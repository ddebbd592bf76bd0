// What an external program gave as one text of a ledger's row, in JSON, which SQLite can look into:
// {"f": 3.2, "settlement": {"x": [0, 1], "y": [0, 0.4]}}. Numbers read back to the same bits.
#pragma once

#include <string>
#include <vector>

#include "solver/channels.hpp"

namespace cpt::results {

/// Empty of none.
[[nodiscard]] std::string output_text(const std::vector<solver::ProgramResult>& results);

/// Throws Error where it is no such text.
[[nodiscard]] std::vector<solver::ProgramResult> parse_output_text(const std::string& text);

}  // namespace cpt::results

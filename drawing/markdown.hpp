// Pieces of Markdown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cpt::drawing {

/// "| a | b |" and a line end; bars and line ends inside a cell are made harmless.
[[nodiscard]] std::string table_line(const std::vector<std::string>& cells);
/// Names of the columns and the line below them.
[[nodiscard]] std::string table_head(const std::vector<std::string>& columns);

}  // namespace cpt::drawing

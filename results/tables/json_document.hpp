// Tables as one JSON document: an object with an array of objects, one a row, for each table.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "results/tables/table_format.hpp"

namespace cpt::results {

/// `format` says what the document is, and comes first; `version` is that of its tables. One line a row.
/// Numbers read back to the same double; empty cells are null.
[[nodiscard]] std::string json_document(std::string_view format, int version,
                                        std::span<const NamedTable> tables);

}  // namespace cpt::results

// Tables as one JSON document: an object with an array of objects, one a row, for each table.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/field_table.hpp"
#include "parameters/study_error.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// `format` says what the document is, and comes first; `version` is that of its tables. One line a row.
/// Numbers read back to the same double; empty cells are null.
[[nodiscard]] std::string json_document(std::string_view format, int version,
                                        std::span<const NamedTable> tables);

/// The tables of such a document of this format, of at most this version, or what is wrong with it; `file`
/// names it. Numbers come back as the texts that read to the same double, null as no text. Never throws for
/// what the document says.
[[nodiscard]] std::variant<std::vector<parameters::FieldTable>, std::vector<parameters::StudyError>>
read_json_document(std::string_view json, const std::string& file, std::string_view format, int version);

}  // namespace cpt::results

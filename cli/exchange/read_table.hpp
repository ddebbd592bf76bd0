// Files of tables: CSV, Dakota's tabular format, and what `campaign export` wrote.
#pragma once

#include <filesystem>
#include <vector>

#include "parameters/field_table.hpp"
#include "results/tables/import_results.hpp"

namespace cpt::cli {

/// Tables and the files that they were read from, in the same order; a JSON document is one file.
struct TableFiles {
  std::vector<parameters::FieldTable> tables;
  std::vector<results::ImportedFile> files;
};

/// True of a folder and of a file NAME.json.
[[nodiscard]] bool is_export(const std::filesystem::path& source);

/// The tables of an export: a folder of NAME.csv or a JSON document. Throws BadInput with all that is wrong
/// with their form.
[[nodiscard]] TableFiles read_export(const std::filesystem::path& source);

/// One table, its fields set apart by commas, semicolons, tabs or blanks. Throws BadInput likewise.
[[nodiscard]] TableFiles read_table(const std::filesystem::path& file);

}  // namespace cpt::cli

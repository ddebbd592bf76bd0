// A file with one table: CSV, or Dakota's tabular format.
#pragma once

#include <filesystem>

#include "parameters/field_table.hpp"
#include "results/tables/import_results.hpp"

namespace cpt::cli {

/// A table and the file that it was read from.
struct TableFile {
  parameters::FieldTable table;
  results::ImportedFile file;
};

/// One table, its fields set apart by commas, semicolons, tabs or blanks. Throws BadInput with all that is
/// wrong with its form.
[[nodiscard]] TableFile read_table(const std::filesystem::path& file);

}  // namespace cpt::cli

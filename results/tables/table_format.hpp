// A table of cells and its three spellings.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cpt::results {

/// Empty (SQL NULL), whole number, number or text.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Empty for what is not finite.
[[nodiscard]] inline Cell number_cell(double value) {
  return std::isfinite(value) ? Cell(value) : Cell(std::monostate{});
}

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

/// A table and what it is called, as a file or in a document.
struct NamedTable {
  std::string name;
  Table table;
};

enum class Format { table, csv, json };
[[nodiscard]] std::optional<Format> format_from_string(std::string_view name);

/// table: aligned columns for reading, numbers to six figures. csv: RFC 4180 with a header line. json: an
/// array of objects, one a row. csv and json give numbers so that they read back to the same double. Ends
/// with a newline.
[[nodiscard]] std::string format(const Table& table, Format format);

/// Writes the table as a csv file; throws Error if that fails.
void write_csv(const std::filesystem::path& file, const Table& table);

}  // namespace cpt::results

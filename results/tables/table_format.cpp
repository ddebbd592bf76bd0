#include "results/tables/table_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "results/files/atomic_file.hpp"

namespace cpt::results {
namespace {

/// Columns a text takes on a terminal: its code points (the symbols of quantities are one column wide).
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string readable(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  if (const auto* number = std::get_if<double>(&cell)) return fmt::format("{:.6g}", *number);
  if (const auto* text = std::get_if<std::string>(&cell)) {
    std::string line = *text;  // a line break would break the table
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    return line;
  }
  return "-";
}

std::string as_table(const Table& table) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns) widths.push_back(width(column));
  std::vector<std::vector<std::string>> cells;
  std::vector<bool> right(columns, true);
  for (const auto& row : table.rows) {
    auto& line = cells.emplace_back();
    for (std::size_t i = 0; i < columns; ++i) {
      line.push_back(readable(row[i]));
      widths[i] = std::max(widths[i], width(line.back()));
      if (std::holds_alternative<std::string>(row[i])) right[i] = false;
    }
  }
  std::string out;
  const auto put_line = [&](const std::vector<std::string>& line) {
    std::string text;
    for (std::size_t i = 0; i < columns; ++i) {
      const std::string padding(widths[i] - width(line[i]), ' ');
      if (i > 0) text += "  ";
      text += right[i] ? padding + line[i] : line[i] + padding;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + "\n";
  };
  put_line(table.columns);
  std::vector<std::string> rule;
  for (const std::size_t w : widths) rule.emplace_back(w, '-');
  put_line(rule);
  for (const auto& line : cells) put_line(line);
  if (cells.empty()) out += "(none)\n";
  return out;
}

std::string csv_field(const std::string& text) {
  // Many readers drop blanks around a field.
  const bool blank_ends =
      !text.empty() && (std::strchr(" \t", text.front()) || std::strchr(" \t", text.back()));
  if (!blank_ends && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted(1, '"');
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  quoted += '"';
  return quoted;
}

std::string as_csv(const Table& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i > 0) out += ",";
    out += csv_field(table.columns[i]);
  }
  out += "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += ",";
      if (const auto* whole = std::get_if<std::int64_t>(&row[i])) out += fmt::format("{}", *whole);
      if (const auto* number = std::get_if<double>(&row[i])) out += fmt::format("{}", *number);
      if (const auto* text = std::get_if<std::string>(&row[i])) out += csv_field(*text);
    }
    out += "\n";
  }
  return out;
}

std::string as_json(const Table& table) {
  auto rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    auto object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto& value = object[table.columns[i]];
      std::visit(
          [&](const auto& cell) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(cell)>, std::monostate>) value = cell;
          },
          row[i]);
    }
    rows.push_back(std::move(object));
  }
  // Text that is not UTF-8 (a query may make some) is replaced, not fatal.
  return rows.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::optional<Format> format_from_string(std::string_view name) {
  if (name == "table") return Format::table;
  if (name == "csv") return Format::csv;
  if (name == "json") return Format::json;
  return std::nullopt;
}

std::string format(const Table& table, Format format) {
  switch (format) {
    case Format::csv:
      return as_csv(table);
    case Format::json:
      return as_json(table);
    case Format::table:
      break;
  }
  return as_table(table);
}

void write_csv(const std::filesystem::path& file, const Table& table) { replace_file(file, as_csv(table)); }

}  // namespace cpt::results

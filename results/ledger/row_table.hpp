// A table of the ledger told once: from its columns and the members of a row that they hold follow its
// definition, how rows are written and read, and how they are shown. Used in this folder and by reports.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "results/files/database.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

struct ColumnDefinition {
  std::string name;
  std::string_view type;  ///< TEXT, INTEGER, REAL or BLOB
  std::string rule;       ///< what stands behind the type: "NOT NULL"
};

/// A table as the database has it.
struct TableDefinition {
  std::string name;
  std::vector<ColumnDefinition> columns;
  std::string rules;  ///< of the whole table, behind its columns: "PRIMARY KEY (realization, window)"
  std::string order;  ///< of its rows, as SQL
};

template <class Row>
struct RowColumn : ColumnDefinition {
  std::function<void(Statement&, const Row&)> bind;
  std::function<void(const Statement&, int, Row&)> read;  ///< the statement's column of this number
  std::function<Cell(const Row&)> cell;                   ///< NaN and empty text that may be NULL: no value
};

template <class Row>
struct RowTable {
  std::string name;
  std::vector<RowColumn<Row>> columns;
  std::string rules, order;

  [[nodiscard]] TableDefinition definition() const {
    return {name, std::vector<ColumnDefinition>(columns.begin(), columns.end()), rules, order};
  }
};

template <class T>
constexpr std::string_view type_of() {
  if constexpr (std::is_same_v<T, std::string>)
    return "TEXT";
  else if constexpr (std::is_integral_v<T>)
    return "INTEGER";
  else if constexpr (std::is_same_v<T, double>)
    return "REAL";
  else
    return "BLOB";
}

/// `get` gives a reference to what a row holds, a constant one of a constant row. Empty text and arrays are
/// NULL where the rule lets them.
template <class Row, class Get>
RowColumn<Row> column_of(std::string name, std::string rule, Get get) {
  using T = std::remove_cvref_t<std::invoke_result_t<Get, Row&>>;
  const bool required = rule.starts_with("NOT NULL") || rule.starts_with("PRIMARY KEY");
  RowColumn<Row> column;
  column.name = std::move(name);
  column.type = type_of<T>();
  column.rule = std::move(rule);
  column.bind = [get, required](Statement& statement, const Row& row) {
    const T& value = get(row);
    if constexpr (std::is_same_v<T, std::string>)
      required ? statement.bind(value) : statement.bind_or_null(value);
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      required || !value.empty() ? statement.bind(value) : statement.bind_or_null("");
    else if constexpr (std::is_integral_v<T>)
      statement.bind(static_cast<std::int64_t>(value));
    else
      statement.bind(value);
  };
  column.read = [get](const Statement& statement, int place, Row& row) {
    T& value = get(row);
    if constexpr (std::is_same_v<T, std::string>)
      value = statement.text(place);
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      value = statement.doubles(place);
    else if constexpr (std::is_integral_v<T>)
      value = static_cast<T>(statement.integer(place));
    else
      value = statement.number(place);
  };
  column.cell = [get](const Row& row) -> Cell {
    const T& value = get(row);
    if constexpr (std::is_same_v<T, std::string>)
      return value;
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      return static_cast<std::int64_t>(value.size());
    else if constexpr (std::is_integral_v<T>)
      return static_cast<std::int64_t>(value);
    else
      return number_cell(value);
  };
  return column;
}

/// A member of the row, or a member of a member.
template <class Row, class T>
RowColumn<Row> column(std::string name, std::string rule, T Row::*member) {
  return column_of<Row>(
      std::move(name), std::move(rule), [member](auto& row) -> auto& { return row.*member; });
}
template <class Row, class Part, class T>
RowColumn<Row> column(std::string name, std::string rule, Part Row::*part, T Part::*member) {
  return column_of<Row>(
      std::move(name), std::move(rule), [ part, member ](auto& row) -> auto& { return row.*part.*member; });
}

/// "id, parameter, side"
template <class Columns>
std::string names_of(const Columns& columns) {
  std::string names;
  for (const auto& column : columns) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

/// All rows as a table for files, in the table's columns.
template <class Row>
Table table_of(const RowTable<Row>& of, const std::vector<Row>& rows) {
  Table table;
  for (const RowColumn<Row>& column : of.columns) table.columns.push_back(column.name);
  for (const Row& row : rows) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    for (const RowColumn<Row>& column : of.columns) cells.push_back(column.cell(row));
  }
  return table;
}

template <class Row>
void insert_row(const Database& database, const RowTable<Row>& table, const Row& row) {
  std::string places;
  for (std::size_t k = 0; k < table.columns.size(); ++k) places += k == 0 ? "?" : ", ?";
  Statement statement = database.prepare("INSERT INTO " + table.name + " (" + names_of(table.columns) +
                                         ") VALUES (" + places + ")");
  for (const RowColumn<Row>& column : table.columns) column.bind(statement, row);
  statement.run();
}

template <class Row>
Row row_of(const RowTable<Row>& table, const Statement& statement) {
  Row row;
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    table.columns[k].read(statement, static_cast<int>(k), row);
  return row;
}

/// "SELECT all columns FROM table"; `rest` is put behind.
template <class Row>
Statement select_rows(const Database& database, const RowTable<Row>& table, std::string_view rest) {
  return database.prepare("SELECT " + names_of(table.columns) + " FROM " + table.name + ' ' +
                          std::string(rest));
}

/// All rows in the table's order.
template <class Row>
std::vector<Row> read_rows(const Database& database, const RowTable<Row>& table) {
  std::vector<Row> rows;
  Statement statement = select_rows(database, table, "ORDER BY " + table.order);
  while (statement.step()) rows.push_back(row_of(table, statement));
  return rows;
}

/// Rows with these columns alone, for a page or another program.
template <class Row>
Table table_with(const std::vector<Row>& rows, const RowTable<Row>& table,
                 const std::vector<std::string_view>& names) {
  std::vector<const RowColumn<Row>*> shown;
  Table made;
  for (const std::string_view name : names)
    for (const RowColumn<Row>& column : table.columns)
      if (column.name == name) {
        shown.push_back(&column);
        made.columns.push_back(column.name);
      }
  for (const Row& row : rows) {
    std::vector<Cell>& cells = made.rows.emplace_back();
    cells.reserve(shown.size());
    for (const RowColumn<Row>* column : shown) cells.push_back(column->cell(row));
  }
  return made;
}

}  // namespace cpt::results

// What a statement answers, as a table.
#pragma once

#include "results/files/database.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// All rows that are still to come, with the names of the columns.
[[nodiscard]] inline Table rows_of(Statement statement) {
  Table table;
  for (int i = 0; i < statement.columns(); ++i) table.columns.push_back(statement.column_name(i));
  while (statement.step()) {
    std::vector<Cell>& row = table.rows.emplace_back();
    for (int i = 0; i < statement.columns(); ++i) row.push_back(statement.cell(i));
  }
  return table;
}

}  // namespace cpt::results

#include "results/ledger/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/views.hpp"

namespace cpt::results {
namespace {

constexpr std::int64_t application_id = 0x43505443;  // "CPTC"

std::vector<std::string> stored_columns(const Database& database, std::string_view table) {
  std::vector<std::string> names;
  Statement rows = database.prepare("SELECT name FROM pragma_table_info(?, 'main')");
  rows.bind(table);
  while (rows.step()) names.push_back(rows.text(0));
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// The table's columns that are stored.
std::vector<ColumnDefinition> kept(const TableDefinition& table, const std::vector<std::string>& stored) {
  std::vector<ColumnDefinition> columns;
  for (const ColumnDefinition& column : table.columns)
    if (contains(stored, column.name)) columns.push_back(column);
  return columns;
}

}  // namespace

bool has_table(const Database& database, std::string_view table) {
  return database.prepare("SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?").bind(table).step();
}

void create_schema(const Database& database) {
  for (const TableDefinition& table : ledger_tables()) database.execute(definition_of(table));
  database.execute("CREATE INDEX realization_of_bound ON realization (parameter, side)");
  for (const View& view : views()) database.execute(view.definition);
  database.execute(
      fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, schema_version));
}

// Rows are taken over as they are; what an earlier version did not store is NULL.
void upgrade_schema(const Database& database) {
  if (database.integer("PRAGMA user_version") == schema_version) return;
  for (const View& view : views()) database.execute(fmt::format("DROP VIEW IF EXISTS {}", view.name));
  database.execute("DROP INDEX IF EXISTS realization_of_bound");
  std::vector<TableDefinition> old;
  for (const TableDefinition& table : ledger_tables())
    if (has_table(database, table.name)) old.push_back(table);
  // A table after those that refer to it, and before them in the end.
  for (auto table = old.rbegin(); table != old.rend(); ++table)
    database.execute(fmt::format("ALTER TABLE {0} RENAME TO old_{0}", table->name));
  create_schema(database);
  for (const TableDefinition& table : old)
    database.execute(fmt::format("INSERT INTO {0} ({1}) SELECT {1} FROM old_{0}", table.name,
                                 names_of(kept(table, stored_columns(database, "old_" + table.name)))));
  for (auto table = old.rbegin(); table != old.rend(); ++table)
    database.execute(fmt::format("DROP TABLE old_{}", table->name));
}

void mend_views(const Database& database) {
  for (const View& view : views()) {
    Statement stored = database.prepare("SELECT sql FROM sqlite_schema WHERE type = 'view' AND name = ?");
    stored.bind(view.name);
    // SQLite keeps the text from CREATE to the semicolon.
    const std::string_view text(view.definition);
    const auto start = text.find("CREATE");
    if (stored.step() && stored.text(0) == text.substr(start, text.rfind(';') - start)) continue;
    database.execute(fmt::format("DROP VIEW IF EXISTS {}", view.name));
    database.execute(view.definition);
  }
}

void show_as_present(const Database& database) {
  if (database.integer("PRAGMA user_version") == schema_version) return;
  database.execute("PRAGMA temp_store = MEMORY");
  for (const TableDefinition& table : ledger_tables()) {
    const std::vector<std::string> stored = stored_columns(database, table.name);
    if (kept(table, stored).size() == table.columns.size()) continue;
    std::string shown;
    for (const ColumnDefinition& column : table.columns)
      shown += fmt::format("{}{}{}", shown.empty() ? "" : ", ",
                           contains(stored, column.name) ? "" : "NULL AS ", column.name);
    database.execute(fmt::format("CREATE TEMP VIEW {0} AS SELECT {1}{2}", table.name, shown,
                                 stored.empty() ? " WHERE 0" : " FROM main." + table.name));
  }
}

Database open_ledger(const std::filesystem::path& file) {
  Database database(file, Database::Mode::read_only);
  check_schema(database);
  database.execute("PRAGMA temp_store = MEMORY");
  show_as_present(database);
  for (const View& view : views()) {
    std::string definition = view.definition;
    definition.replace(definition.find("CREATE VIEW"), 11, "CREATE TEMP VIEW");
    database.execute(definition);
  }
  return database;
}

bool is_empty(const Database& database) {
  return database.integer("SELECT count(*) FROM sqlite_schema") == 0;
}

void check_schema(const Database& database) {
  const std::string file = database.file().string();
  if (database.integer("PRAGMA application_id") != application_id)
    throw Error(file + ": an SQLite database, but not one of a campaign; name another file");
  const auto version = database.integer("PRAGMA user_version");
  if (version < oldest_schema_version || version > schema_version)
    throw Error(
        fmt::format("{}: has schema version {}, this program knows version {}; use the program that wrote "
                    "it, or move the file away and run again",
                    file, version, schema_version));
}

}  // namespace cpt::results

#include "results/tables/campaign_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "results/files/database.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/samples.hpp"
#include "results/tables/statement_rows.hpp"

namespace cpt::results {
namespace {

constexpr const char* orders[][2] = {{"campaign", "one"},
                                     {"layer", "position"},
                                     {"parameter", "position"},
                                     {"depth_window", "position"},
                                     {"realization", "id"},
                                     {"curve", "realization"},
                                     {"window_mean", "realization, window"},
                                     {"repeat_noise", "window"},
                                     {"checksum", "realization"},
                                     {"import", "position"}};

std::vector<LedgerTable> read_definitions() {
  const Database model(":memory:", Database::Mode::read_write);
  create_schema(model);
  std::vector<LedgerTable> tables;
  for (const auto& [name, order] : orders) {
    LedgerTable table{name, order, {}};
    Statement columns =
        model.prepare("SELECT name, type, \"notnull\" OR pk FROM pragma_table_info(?) WHERE name <> 'one'");
    columns.bind(name);
    while (columns.step())
      table.columns.push_back({columns.text(0), columns.text(1), columns.integer(2) != 0});
    if (table.name == "curve")
      table.columns = {{"realization", "INTEGER", true},
                       {"depth_m", "REAL", true},
                       {"q_c_Pa", "REAL", false},
                       {"f_s_Pa", "REAL", false}};
    tables.push_back(std::move(table));
  }
  return tables;
}

Table stored_rows(const Database& database, const LedgerTable& table) {
  std::string columns;
  for (const LedgerTable::Column& column : table.columns)
    columns += (columns.empty() ? "" : ", ") + column.name;
  const bool stored =  // earlier schema versions lack some
      database.prepare("SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = ?")
          .bind(table.name)
          .step();
  if (!stored) {
    Table none;
    for (const LedgerTable::Column& column : table.columns) none.columns.push_back(column.name);
    return none;
  }
  return rows_of(
      database.prepare(fmt::format("SELECT {} FROM {} ORDER BY {}", columns, table.name, table.order)));
}

Table curve_rows(const Snapshot& s) {
  Table table{{"realization", "depth_m", "q_c_Pa", "f_s_Pa"}, {}};
  for (const CurveRow& curve : s.curves)
    for (std::size_t i = 0; i < curve.profile.depth.size(); ++i) {
      std::vector<Cell>& row = table.rows.emplace_back();
      row.reserve(table.columns.size());
      row.emplace_back(std::int64_t{curve.realization});
      for (const auto* values : {&curve.profile.depth, &curve.profile.q_c, &curve.profile.f_s})
        std::isnan((*values)[i]) ? row.emplace_back() : row.emplace_back((*values)[i]);
    }
  return table;
}

}  // namespace

const std::vector<LedgerTable>& ledger_tables() {
  static const std::vector<LedgerTable> tables = read_definitions();
  return tables;
}

std::span<const std::string_view> derived_tables() {
  static constexpr std::array<std::string_view, 5> names = {"samples", "audit", "sensitivity", "tornado",
                                                            "effects"};
  return names;
}

std::vector<NamedTable> campaign_tables(const std::filesystem::path& file) {
  return campaign_tables(open_ledger(file));
}

std::vector<NamedTable> campaign_tables(const Database& database) {
  const Transaction transaction(database, Transaction::Kind::read);
  const Snapshot snapshot = read_snapshot(database);
  std::vector<NamedTable> tables;
  for (const LedgerTable& table : ledger_tables())
    tables.push_back(
        {table.name, table.name == "curve" ? curve_rows(snapshot) : stored_rows(database, table)});
  tables.push_back({"samples", samples_table(snapshot)});
  for (const char* view : {"audit", "sensitivity", "tornado"})
    tables.push_back({view, rows_of(database.prepare(fmt::format("SELECT * FROM {}", view)))});
  tables.push_back({"effects", effects_table(design_effects(snapshot))});
  return tables;
}

}  // namespace cpt::results

#include "results/tables/campaign_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "results/files/database.hpp"
#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"
#include "results/tables/output_names.hpp"
#include "results/tables/samples.hpp"
#include "results/tables/statement_rows.hpp"

namespace cpt::results {
namespace {

// What the study no longer asks for is no part of the campaign; what the design says is told as it is now.
constexpr std::string_view left_out[] = {"former_study",         unused_tables.run, unused_tables.curve,
                                         unused_tables.checksum, "effect",          "depth_band"};

Table stored_rows(const Database& database, const TableDefinition& table) {
  std::vector<ColumnDefinition> columns = table.columns;
  std::erase_if(columns, [](const ColumnDefinition& column) { return column.name == "one"; });
  return rows_of(database.prepare(
      fmt::format("SELECT {} FROM {} ORDER BY {}", names_of(columns), table.name, table.order)));
}

/// Not as they are stored: a row a depth bin.
Table curve_rows(const Snapshot& s) {
  if (s.is_external()) return output_rows(s);
  Table table{{"realization", "depth_m"}, {}};
  for (const solver::Channel& channel : solver::channels()) table.columns.push_back(in_unit(channel, "Pa"));
  for (const CurveRow& curve : s.curves)
    for (std::size_t i = 0; i < curve.profile.depth.size(); ++i) {
      std::vector<Cell>& row = table.rows.emplace_back();
      row.reserve(table.columns.size());
      row.emplace_back(std::int64_t{curve.realization});
      row.push_back(number_cell(curve.profile.depth[i]));
      for (const solver::Channel& channel : solver::channels()) {
        const std::vector<double>& values = curve.profile.*channel.values;
        row.push_back(values.empty() ? Cell() : number_cell(values[i]));
      }
    }
  return table;
}

}  // namespace

Table output_rows(const Snapshot& s) {
  Table table{{"realization", "output", "x", "y"}, {}};
  for (const CurveRow& curve : s.curves)
    for (const solver::ProgramResult& result : curve.profile.declared)
      for (std::size_t i = 0; i < result.y.size(); ++i)
        table.rows.push_back({std::int64_t{curve.realization}, result.name,
                              result.x.empty() ? Cell() : number_cell(result.x[i]),
                              number_cell(result.y[i])});
  return table;
}

std::vector<NamedTable> campaign_tables(const std::filesystem::path& file) {
  return campaign_tables(open_ledger(file));
}

std::vector<NamedTable> campaign_tables(const Database& database) {
  const Transaction transaction(database, Transaction::Kind::read);
  const Snapshot snapshot = read_snapshot(database);
  std::vector<NamedTable> tables;
  for (const TableDefinition& table : ledger_tables())
    if (std::ranges::find(left_out, table.name) == std::end(left_out))
      tables.push_back({table.name, table.name == in_use_tables.curve
                                        ? curve_rows(snapshot)
                                        : named_for_outputs(stored_rows(database, table), database)});
  tables.push_back({"samples", samples_table(snapshot)});
  for (const char* view : {"audit", "sensitivity", "tornado"})
    tables.push_back({view, named_for_outputs(
                                rows_of(database.prepare(fmt::format("SELECT * FROM {}", view))), database)});
  const Effects effects = design_effects(snapshot);
  tables.push_back({"effects", effects_table(effects)});
  tables.push_back({"bands", bands_table(effects)});
  return tables;
}

}  // namespace cpt::results

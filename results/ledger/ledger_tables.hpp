// The tables of the ledger, each told once. docs/schema.md explains every column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "results/ledger/row_table.hpp"
#include "results/ledger/run_tables.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

[[nodiscard]] const RowTable<CampaignRow>& campaign_table();
[[nodiscard]] const RowTable<LayerRow>& layer_table();
[[nodiscard]] const RowTable<ParameterRow>& parameter_table();
[[nodiscard]] const RowTable<WindowRow>& window_table();
[[nodiscard]] const RowTable<InputRow>& input_table();
[[nodiscard]] const RowTable<WindowMeanRow>& window_mean_table();
[[nodiscard]] const RowTable<RepeatNoiseRow>& repeat_noise_table();
[[nodiscard]] const RowTable<ImportRow>& import_table();
[[nodiscard]] const RowTable<OutputRow>& output_table();
/// Of runs in use or of unused ones, which have a column more, their former study.
[[nodiscard]] const RowTable<RealizationRow>& run_table(const RunTables& tables);
/// With a column for each channel.
[[nodiscard]] const RowTable<CurveRow>& curve_table(const RunTables& tables);

/// Columns of a run that say how it ended; all others say what it is.
[[nodiscard]] bool is_outcome(const ColumnDefinition& column);
/// Columns of a run that its checksum covers, in the checksum's order.
[[nodiscard]] const std::vector<RowColumn<RealizationRow>>& sealed_columns();
/// The first of them are sealed by every program; those that came later, where they are NULL, leave the
/// checksums of earlier programs as they are.
inline constexpr std::size_t always_sealed = 14;

/// All tables, each behind those that it refers to.
[[nodiscard]] const std::vector<TableDefinition>& ledger_tables();
/// "CREATE TABLE ..." of one.
[[nodiscard]] std::string definition_of(const TableDefinition& table);

}  // namespace cpt::results

#include "results/ledger/ledger_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "results/ledger/effect_tables.hpp"
#include "results/ledger/output_text.hpp"
#include "solver/channels.hpp"

namespace cpt::results {
namespace {

const std::string needed = "NOT NULL", key = "PRIMARY KEY", place_of_row = "NOT NULL UNIQUE";
// What belongs to a run is renumbered and goes with it.
std::string of_run(std::string_view run) {
  return fmt::format("NOT NULL REFERENCES {} (id) ON UPDATE CASCADE ON DELETE CASCADE", run);
}
std::string one_of_run(std::string_view run) {
  return fmt::format("PRIMARY KEY REFERENCES {} (id) ON UPDATE CASCADE ON DELETE CASCADE", run);
}

using Run = RealizationRow;
using solver::Audit;

std::vector<RowColumn<Run>> run_columns() {
  return {
      column("id", key, &Run::id),
      column("parameter", "", &Run::parameter),
      column("side", "NOT NULL CHECK (side IN ('baseline', 'lower', 'upper', 'point', 'repeat'))",
             &Run::side),
      column("value", "", &Run::value),
      column("value_text", needed, &Run::value_text),
      column(
          "status",
          "NOT NULL CHECK (status IN ('pending', 'running', 'completed', 'did_not_converge', 'energy_drift', "
          "'time_limit', 'invalid_parameters', 'crashed', 'rank_lost', 'not_needed'))",
          &Run::status),
      column("reason", "NOT NULL DEFAULT ''", &Run::reason),
      column("wall_s", "", &Run::wall_s),
      column("steps", "", &Run::steps),
      column("material_points", "", &Run::material_points),
      column("settings_hash", needed, &Run::settings_hash),
      column("solver_version", needed, &Run::solver_version),
      column("started", "", &Run::started),
      column("finished", "", &Run::finished),
      column("mass_error", "", &Run::audit, &Audit::mass_error),
      column("momentum_error", "", &Run::audit, &Audit::momentum_error),
      column("energy_error", "", &Run::audit, &Audit::energy_error),
      column("kinetic_fraction", "", &Run::audit, &Audit::kinetic_fraction),
      column("max_empty_cells", "", &Run::audit, &Audit::max_empty_cells),
      column("limited_share", "", &Run::audit, &Audit::limited_share),
      column("safeguarded_share", "", &Run::audit, &Audit::safeguarded_share),
      column("min_time_step_s", "", &Run::audit, &Audit::min_time_step),
      column("max_time_step_s", "", &Run::audit, &Audit::max_time_step),
  };
}

RowTable<Run> unused_runs_table() {
  RowTable<Run> table{unused_tables.run, run_columns(), "", "id"};
  table.columns.push_back(column("study", "NOT NULL REFERENCES former_study (id)", &Run::former_study));
  return table;
}

RowTable<CurveRow> make_curve_table(const RunTables& tables) {
  using Profile = solver::DepthProfile;
  RowTable<CurveRow> table{tables.curve,
                           {column("realization", one_of_run(tables.run), &CurveRow::realization)},
                           "",
                           "realization"};
  RowColumn<CurveRow> bins = column("bins", needed, &CurveRow::realization);
  bins.bind = [](Statement& statement, const CurveRow& row) {
    statement.bind(static_cast<std::int64_t>(row.profile.depth.size()));
  };
  bins.read = [](const Statement&, int, CurveRow&) {};  // the arrays tell
  table.columns.push_back(std::move(bins));
  table.columns.push_back(column("depth_m", needed, &CurveRow::profile, &Profile::depth));
  for (const solver::Channel& channel : solver::channels())
    table.columns.push_back(
        column(in_unit(channel, "Pa"), channel.required ? needed : "", &CurveRow::profile, channel.values));
  RowColumn<CurveRow> outputs;
  outputs.name = "outputs";
  outputs.type = "TEXT";
  outputs.bind = [](Statement& statement, const CurveRow& row) {
    statement.bind_or_null(output_text(row.profile.declared));
  };
  outputs.read = [](const Statement& statement, int place, CurveRow& row) {
    row.profile.declared = parse_output_text(statement.text(place));
  };
  outputs.cell = [](const CurveRow& row) -> Cell { return output_text(row.profile.declared); };
  table.columns.push_back(std::move(outputs));
  return table;
}

RowTable<WindowMeanRow> make_window_mean_table() {
  using Mean = WindowMeanRow;
  RowTable<Mean> table{
      "window_mean",
      {column("realization", of_run("realization"), &Mean::realization),
       column("window", "NOT NULL REFERENCES depth_window (name)", &Mean::window),
       column("from_m", needed, &Mean::from_m), column("to_m", needed, &Mean::to_m),
       column("bins", "", &Mean::bins), column("q_c_mean_kPa", needed, &Mean::q_c_mean_kPa),
       column("q_c_min_kPa", "", &Mean::q_c_min_kPa), column("q_c_max_kPa", "", &Mean::q_c_max_kPa)},
      "PRIMARY KEY (realization, window)",
      "realization, (SELECT position FROM depth_window WHERE name = window)"};
  // Without a number of bins the average was imported.
  table.columns[4].bind = [](Statement& statement, const Mean& row) {
    row.bins > 0 ? statement.bind(row.bins) : statement.bind_or_null("");
  };
  for (std::size_t k = 1; k < solver::channels().size(); ++k)
    table.columns.push_back(column_of<Mean>(
        in_unit(solver::channels()[k], "mean_kPa"),
        "", [k](auto& row) -> auto& { return row.other_means_kPa[k - 1]; }));
  return table;
}

TableDefinition checksums_of(const RunTables& tables) {
  return {tables.checksum,
          {{"realization", "INTEGER", one_of_run(tables.run)}, {"sha256", "TEXT", needed}},
          "",
          "realization"};
}

std::vector<TableDefinition> make_ledger_tables() {
  return {campaign_table().definition(),
          layer_table().definition(),
          parameter_table().definition(),
          window_table().definition(),
          run_table(in_use_tables).definition(),
          input_table().definition(),
          curve_table(in_use_tables).definition(),
          window_mean_table().definition(),
          repeat_noise_table().definition(),
          checksums_of(in_use_tables),
          {"former_study",
           {{"id", "INTEGER", key},
            {"name", "TEXT", needed},
            {"study_text", "TEXT", needed},
            {"baseline_setup", "TEXT", needed},
            {"program_version", "TEXT", needed}},
           "",
           "id"},
          run_table(unused_tables).definition(),
          curve_table(unused_tables).definition(),
          checksums_of(unused_tables),
          import_table().definition(),
          effect_table().definition(),
          depth_band_table().definition(),
          output_table().definition()};
}

}  // namespace

const RowTable<CampaignRow>& campaign_table() {
  using C = CampaignRow;
  static const RowTable<C> table = {
      "campaign",
      {column("one", "PRIMARY KEY CHECK (one = 1)", &C::one), column("name", needed, &C::name),
       column("title", needed, &C::title), column("profile", needed, &C::profile),
       column("preset", needed, &C::preset), column("study_text", needed, &C::study_text),
       column("baseline_setup", needed, &C::baseline_setup),
       column("program_version", needed, &C::program_version),
       column("solver_version", needed, &C::solver_version), column("curve_file", needed, &C::curve_file),
       column("created", needed, &C::created)},
      "",
      "one"};
  return table;
}

const RowTable<LayerRow>& layer_table() {
  static const RowTable<LayerRow> table = {
      "layer",
      {column("position", key, &LayerRow::position), column("top_m", needed, &LayerRow::top_m),
       column("bottom_m", needed, &LayerRow::bottom_m), column("soil", needed, &LayerRow::soil)},
      "",
      "position"};
  return table;
}

const RowTable<ParameterRow>& parameter_table() {
  using P = ParameterRow;
  static const RowTable<P> table = {
      "parameter",
      {column("name", key, &P::name), column("position", place_of_row, &P::position),
       column("symbol", needed, &P::symbol), column("unit", needed, &P::unit),
       column("meaning", needed, &P::meaning), column("baseline", needed, &P::baseline),
       column("lower", needed, &P::lower), column("upper", needed, &P::upper),
       column("baseline_text", needed, &P::baseline_text), column("lower_text", needed, &P::lower_text),
       column("upper_text", needed, &P::upper_text)},
      "",
      "position"};
  return table;
}

const RowTable<WindowRow>& window_table() {
  using W = WindowRow;
  static const RowTable<W> table = {
      "depth_window",
      {column("name", key, &W::name), column("position", place_of_row, &W::position),
       column("kind", "NOT NULL CHECK (kind IN ('fixed', 'peak', 'trough', 'scalar'))", &W::kind),
       column("search_from_m", needed, &W::search_from_m), column("search_to_m", needed, &W::search_to_m),
       column("width_m", "", &W::width_m), column("from_m", "", &W::from_m), column("to_m", "", &W::to_m),
       column("problem", needed, &W::problem), column("output", "", &W::output),
       column("output_unit", "", &W::output_unit)},
      "",
      "position"};
  return table;
}

const RowTable<InputRow>& input_table() {
  using I = InputRow;
  static const RowTable<I> table = {
      "realization_input",
      {column("realization", of_run("realization"), &I::realization),
       column("quantity", needed, &I::quantity), column("value", needed, &I::value),
       column("value_text", needed, &I::value_text)},
      "PRIMARY KEY (realization, quantity)",
      "realization, quantity"};
  return table;
}

const RowTable<WindowMeanRow>& window_mean_table() {
  static const RowTable<WindowMeanRow> table = make_window_mean_table();
  return table;
}

const RowTable<RepeatNoiseRow>& repeat_noise_table() {
  using N = RepeatNoiseRow;
  static const RowTable<N> table = {
      "repeat_noise",
      {column("window", "PRIMARY KEY REFERENCES depth_window (name)", &N::window),
       column("runs", needed, &N::runs), column("q_c_mean_kPa", needed, &N::q_c_mean_kPa),
       column("q_c_deviation_kPa", needed, &N::q_c_deviation_kPa),
       column("si_half_width", needed, &N::si_half_width)},
      "",
      "window"};
  return table;
}

const RowTable<ImportRow>& import_table() {
  using I = ImportRow;
  static const RowTable<I> table = {
      "import",
      {column("position", key, &I::position), column("file", needed, &I::file),
       column("sha256", needed, &I::sha256), column("imported", needed, &I::imported),
       column("program_version", needed, &I::program_version)},
      "",
      "position"};
  return table;
}

const RowTable<OutputRow>& output_table() {
  using O = OutputRow;
  static const RowTable<O> table = {
      "program_output",
      {column("name", key, &O::name), column("position", place_of_row, &O::position),
       column("unit", needed, &O::unit), column("meaning", needed, &O::meaning),
       column("over_name", "", &O::over), column("over_unit", "", &O::over_unit)},
      "",
      "position"};
  return table;
}

const RowTable<RealizationRow>& run_table(const RunTables& tables) {
  static const RowTable<Run> in_use = {in_use_tables.run, run_columns(), "", "id"},
                             unused = unused_runs_table();
  return tables.run == std::string_view(unused_tables.run) ? unused : in_use;
}

const RowTable<CurveRow>& curve_table(const RunTables& tables) {
  static const RowTable<CurveRow> in_use = make_curve_table(in_use_tables),
                                  unused = make_curve_table(unused_tables);
  return tables.run == std::string_view(unused_tables.run) ? unused : in_use;
}

bool is_outcome(const ColumnDefinition& column) {
  static constexpr std::array<std::string_view, 8> what_it_is = {
      "id", "parameter", "side", "value", "value_text", "settings_hash", "solver_version", "study"};
  return std::ranges::find(what_it_is, column.name) == what_it_is.end();
}

const std::vector<RowColumn<RealizationRow>>& sealed_columns() {
  static const auto sealed = [] {
    std::vector<RowColumn<Run>> columns;
    const std::vector<RowColumn<Run>> all = run_columns();
    for (const char* name :
         {"settings_hash", "solver_version", "status", "reason", "steps", "material_points",
          "max_empty_cells", "wall_s", "mass_error", "momentum_error", "energy_error", "kinetic_fraction",
          "min_time_step_s", "max_time_step_s", "limited_share", "safeguarded_share"})
      columns.push_back(*std::ranges::find(all, name, &RowColumn<Run>::name));
    return columns;
  }();
  return sealed;
}

const std::vector<TableDefinition>& ledger_tables() {
  static const std::vector<TableDefinition> tables = make_ledger_tables();
  return tables;
}

std::string definition_of(const TableDefinition& table) {
  std::string text = fmt::format("CREATE TABLE {} (\n", table.name);
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const ColumnDefinition& column = table.columns[k];
    text += fmt::format("{}  {:<16} {}{}{}", k == 0 ? "" : ",\n", column.name, column.type,
                        column.rule.empty() ? "" : " ", column.rule);
  }
  if (!table.rules.empty()) text += ",\n  " + table.rules;
  // A table with a key of several columns is kept by that key.
  text += table.rules.empty() ? "\n)" : "\n) WITHOUT ROWID";
  return text + ";\n";
}

}  // namespace cpt::results

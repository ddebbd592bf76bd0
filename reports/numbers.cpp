#include "reports/numbers.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/model_remarks.hpp"
#include "results/tables/campaign_tables.hpp"
#include "results/tables/output_names.hpp"
#include "solver/channels.hpp"

namespace cpt::reports {
namespace {

using results::Cell;
using results::Snapshot;
using results::Table;

Cell number_or_empty(double value) { return std::isfinite(value) ? Cell(value) : Cell(std::monostate{}); }
Cell whole(std::int64_t value) { return Cell(value); }
Cell flag(std::optional<bool> value) {
  Cell cell;
  if (value) cell = static_cast<std::int64_t>(*value);
  return cell;
}

template <class... Cells>
void add_row(Table& table, const Cells&... cells) {
  std::vector<Cell>& row = table.rows.emplace_back();
  row.reserve(sizeof...(cells));
  (row.emplace_back(cells), ...);
}

Table campaign_table(const Snapshot& s) {
  return results::table_with(std::vector{s.campaign}, results::campaign_table(),
                             {"name", "title", "profile", "preset", "program_version", "solver_version",
                              "created", "study_text", "baseline_setup"});
}

Table parameter_table(const Snapshot& s) {
  Table table{{"name", "symbol", "unit", "meaning", "baseline", "lower", "upper"}, {}};
  for (const auto& p : s.parameters)
    add_row(table, p.name, p.symbol, p.unit, p.meaning, p.baseline_text, p.lower_text, p.upper_text);
  return table;
}

Table import_table(const Snapshot& s) {
  return results::table_with(s.imports, results::import_table(), {"file", "sha256", "imported"});
}

Table window_table(const Snapshot& s) {
  Table table{{"window", "kind", "from_m", "to_m", "problem"}, {}};
  for (const auto& w : s.windows)
    add_row(table, w.name, w.kind, number_or_empty(w.from_m), number_or_empty(w.to_m), w.problem);
  return table;
}

Table output_table(const Snapshot& s) {
  return results::table_with(s.outputs, results::output_table(),
                             {"name", "unit", "meaning", "over_name", "over_unit"});
}

Table repeat_noise_table(const Snapshot& s) {
  return results::table_with(s.repeat_noise, results::repeat_noise_table(),
                             {"window", "runs", "q_c_mean_kPa", "q_c_deviation_kPa", "si_half_width"});
}

}  // namespace

Table sensitivity_table(const Snapshot& s) {
  Table table{
      {"window", "parameter", "q_lower_kPa", "q_upper_kPa", "q_baseline_kPa", "si", "si_abs", "si_noise",
       "above_noise", "si_half_width", "above_repeats", "above_si_noise", "pairs", "note"},
      {}};
  for (const auto& r : s.sensitivity)
    add_row(table, r.window, r.parameter, number_or_empty(r.q_lower_kPa), number_or_empty(r.q_upper_kPa),
            number_or_empty(r.q_baseline_kPa), number_or_empty(r.si), number_or_empty(r.si_abs),
            number_or_empty(r.si_noise), flag(r.above_noise), number_or_empty(r.si_half_width),
            flag(r.above_repeats), flag(r.above_si_noise), r.pairs > 0 ? whole(r.pairs) : Cell(), r.note);
  return table;
}

Table realization_table(const Snapshot& s) {
  Table table{{"id", "parameter", "side", "value", "status", "reason", "wall_s", "steps", "material_points",
               "mass_error", "momentum_error", "energy_error", "kinetic_fraction", "max_empty_cells",
               "limited_share", "safeguarded_share", "out_of_line", "settings_hash", "solver_version"},
              {}};
  for (const auto& r : s.realizations)
    add_row(table, whole(r.id), r.parameter, r.side, r.value_text, r.status, r.reason,
            number_or_empty(r.wall_s), whole(r.steps), whole(r.material_points),
            number_or_empty(r.audit.mass_error), number_or_empty(r.audit.momentum_error),
            number_or_empty(r.audit.energy_error), number_or_empty(r.audit.kinetic_fraction),
            whole(r.audit.max_empty_cells), number_or_empty(r.audit.limited_share),
            number_or_empty(r.audit.safeguarded_share), r.out_of_line, r.settings_hash, r.solver_version);
  return table;
}

Table window_mean_table(const Snapshot& s) {
  std::vector<std::string> names = {"realization",  "window",      "from_m",     "to_m",
                                    "q_c_mean_kPa", "q_c_min_kPa", "q_c_max_kPa"};
  for (const solver::Channel& channel : solver::channels().subspan(1))
    names.push_back(in_unit(channel, "mean_kPa"));
  return results::table_with(s.window_means, results::window_mean_table(), {names.begin(), names.end()});
}

Table curve_table(const Snapshot& s) {
  if (s.is_external()) return results::output_rows(s);
  Table table{{"realization", "depth_m"}, {}};
  for (const solver::Channel& channel : solver::channels()) table.columns.push_back(in_unit(channel, "kPa"));
  for (const auto& curve : s.curves)
    for (std::size_t i = 0; i < curve.profile.depth.size(); ++i) {
      add_row(table, whole(curve.realization), number_or_empty(curve.profile.depth[i]));
      for (const solver::Channel& channel : solver::channels()) {
        const std::vector<double>& values = curve.profile.*channel.values;
        table.rows.back().push_back(values.empty() ? Cell() : number_or_empty(values[i] / 1.0e3));
      }
    }
  return table;
}

std::string report_json(const Snapshot& s, const results::Effects& effects, Names names) {
  const auto rows = [&](Table table) {
    if (names == Names::shown) table = results::named_for_outputs(std::move(table), s);
    return nlohmann::ordered_json::parse(results::format(table, results::Format::json));
  };
  nlohmann::ordered_json all;
  all["campaign"] = rows(campaign_table(s)).at(0);
  all["imports"] = rows(import_table(s));
  all["remarks"] = results::model_remarks(s);
  all["parameters"] = rows(parameter_table(s));
  if (s.is_external()) all["outputs"] = rows(output_table(s));
  all["windows"] = rows(window_table(s));
  all["realizations"] = rows(realization_table(s));
  all["window_means"] = rows(window_mean_table(s));
  all["repeat_noise"] = rows(repeat_noise_table(s));
  all["sensitivity"] = rows(sensitivity_table(s));
  all["design"] = effects.design;
  all["stopped"] = effects.stopped;
  all["numerical_error"] = effects.numerical_error;
  all["effects"] = rows(results::effects_table(effects));
  return all.dump(2) + "\n";
}

}  // namespace cpt::reports

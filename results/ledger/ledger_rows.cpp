#include "results/ledger/ledger_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "parameters/all_realizations.hpp"
#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/provenance.hpp"
#include "results/statistics/repeat_noise.hpp"
#include "results/statistics/windows.hpp"

namespace cpt::results {
namespace {

constexpr double Pa_per_kPa = 1.0e3;

std::string unit_of(const solver::ExternalProgram* program, const std::string& output) {
  if (program == nullptr) return "";
  const auto declared = std::ranges::find(program->outputs, output, &solver::ProgramOutput::name);
  return declared == program->outputs.end() ? "" : declared->unit;
}

/// The window's place, or why it has none yet.
Resolved<Interval> place(const parameters::Window& window, const Database& database) {
  if (window.kind == parameters::Window::Kind::fixed || window.kind == parameters::Window::Kind::scalar)
    return resolve_window(window, {});
  Statement baseline = database.prepare("SELECT id, status FROM realization WHERE side = 'baseline'");
  if (!baseline.step()) return {{}, "the study has no baseline run"};
  const std::string status = baseline.text(1);
  if (status == "completed")
    return resolve_window(window, read_profile(database, static_cast<int>(baseline.integer(0))));
  const bool waiting = status == "pending" || status == "running";
  return {{},
          waiting ? "the window is placed when the baseline run is done"
                  : fmt::format("baseline run failed ({}), which places the window", status)};
}

template <class T>
void append_bytes(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

void check_curve(const Database& database, const CurveRow& curve) {
  if (!solver::is_even(curve.profile))
    fail_damaged(database.file(), fmt::format("the curve of realization {} has columns of different lengths",
                                              curve.realization));
}

std::string_view kind_name(parameters::Window::Kind kind) {
  switch (kind) {
    case parameters::Window::Kind::peak:
      return "peak";
    case parameters::Window::Kind::trough:
      return "trough";
    case parameters::Window::Kind::scalar:
      return "scalar";
    case parameters::Window::Kind::fixed:
      break;
  }
  return "fixed";
}

std::string outcome_checksum(const Database& database, std::int64_t id, const RunTables& tables) {
  std::string bytes;
  const auto append = [&](const std::string& text) {
    append_bytes(bytes, text.size());
    bytes += text;
  };
  const std::vector<RowColumn<RealizationRow>>& sealed = sealed_columns();
  Statement row =
      database.prepare(fmt::format("SELECT {} FROM {} WHERE id = ?", names_of(sealed), tables.run));
  row.bind(id);
  if (row.step())
    for (std::size_t k = 0; k < sealed.size(); ++k) {
      const int column = static_cast<int>(k);
      if (row.is_null(column) && k >= always_sealed) continue;
      if (row.is_null(column))
        append("NULL");
      else if (sealed[k].type == "TEXT")
        append(row.text(column));
      else if (sealed[k].type == "INTEGER")
        append_bytes(bytes, row.integer(column));
      else
        append_bytes(bytes, row.number(column));
    }
  const auto append_array = [&](const std::vector<double>& values) {
    append_bytes(bytes, values.size());
    for (const double value : values) append_bytes(bytes, value);
  };
  const solver::DepthProfile profile = read_profile(database, id, tables);
  append_array(profile.depth);
  // What earlier programs did not record leaves their checksums as they are.
  for (const solver::Channel& channel : solver::channels())
    if (channel.required || !(profile.*channel.values).empty()) append_array(profile.*channel.values);
  for (const solver::ProgramResult& result : profile.declared) {
    append(result.name);
    append_array(result.x);
    append_array(result.y);
  }
  return sha256(bytes);
}

std::optional<bool> matches_checksum(const Database& database, std::int64_t id, const RunTables& tables) {
  Statement stored =
      database.prepare(fmt::format("SELECT sha256 FROM {} WHERE realization = ?", tables.checksum));
  stored.bind(id);
  if (!stored.step()) return std::nullopt;
  Statement bins = database.prepare(fmt::format("SELECT bins FROM {} WHERE realization = ?", tables.curve));
  bins.bind(id);
  try {
    const auto length = static_cast<std::int64_t>(read_profile(database, id, tables).depth.size());
    return stored.text(0) == outcome_checksum(database, id, tables) &&
           (bins.step() ? bins.integer(0) : 0) == length;
  } catch (const Error&) {
    return false;  // a curve of broken length
  }
}

RealizationInput describe_input(const parameters::Study& study, const parameters::Realization& realization) {
  return {std::string(parameters::parameter_name(study, realization)),
          std::string(parameters::to_string(realization.side)),
          parameters::parameter_value(study, realization),
          parameters::value_text(study, realization),
          settings_hash(parameters::make_setup(study, realization)),
          solver_version(study.baseline)};
}

void insert_pending(const Database& database, int id, const RealizationInput& input) {
  database
      .prepare(
          "INSERT INTO realization (id, parameter, side, value, value_text, status, settings_hash, "
          "solver_version) VALUES (?, ?, ?, ?, ?, 'pending', ?, ?)")
      .bind(id)
      .bind_or_null(input.parameter)
      .bind(input.side)
      .bind(input.value)
      .bind(input.value_text)
      .bind(input.settings_hash)
      .bind(input.solver_version)
      .run();
}

void rename_realization(const Database& database, std::int64_t old_id, int new_id,
                        const RealizationInput& input) {
  database
      .prepare(
          "UPDATE realization SET id = ?, parameter = ?, side = ?, value = ?, value_text = ? WHERE id = ?")
      .bind(new_id)
      .bind_or_null(input.parameter)
      .bind(input.side)
      .bind(input.value)
      .bind(input.value_text)
      .bind(old_id)
      .run();
}

void clear_outcome(const Database& database, int id) {
  std::string changes;
  for (const ColumnDefinition& column : run_table(in_use_tables).columns)
    if (is_outcome(column))
      changes += fmt::format("{}{} = {}", changes.empty() ? "" : ", ", column.name,
                             column.name == "status"   ? "'pending'"
                             : column.name == "reason" ? "''"
                                                       : "NULL");
  database.prepare(fmt::format("UPDATE realization SET {} WHERE id = ?", changes)).bind(id).run();
  for (const char* table : {"curve", "checksum"})
    database.prepare(fmt::format("DELETE FROM {} WHERE realization = ?", table)).bind(id).run();
  database.prepare("DELETE FROM window_mean WHERE realization = ?").bind(id).run();
}

void require_waiting(const Database& database, int id) {
  Statement row = database.prepare("SELECT status FROM realization WHERE id = ?");
  row.bind(id);
  if (!row.step()) throw std::logic_error(fmt::format("the ledger has no realization {}", id));
  const std::string status = row.text(0);
  if (status != "pending" && status != "running")
    throw std::logic_error(fmt::format("realization {} has already ended ({})", id, status));
}

void write_study(const Database& database, const parameters::Study& study, const std::string& study_text) {
  const solver::ExternalProgram* external = study.baseline.program.get();
  CampaignRow campaign{study.name,
                       study.title,
                       std::string(external ? "external" : solver::to_string(study.profile)),
                       std::string(external ? "" : solver::to_string(study.preset)),
                       study_text,
                       solver::canonical_text(study.baseline),
                       std::string(program_version()),
                       solver_version(study.baseline),
                       utc_now(),
                       study.curves.filename().string()};
  {
    Statement stored = database.prepare("SELECT created FROM campaign");
    if (stored.step()) campaign.created = stored.text(0);
  }
  database.execute(
      "DELETE FROM campaign; DELETE FROM layer; DELETE FROM parameter; DELETE FROM window_mean; "
      "DELETE FROM repeat_noise; DELETE FROM depth_window; DELETE FROM effect; DELETE FROM depth_band; "
      "DELETE FROM program_output");
  insert_row(database, campaign_table(), campaign);
  int position = 0;
  if (external == nullptr)
    for (const solver::Layer& layer : study.baseline.layers)
      insert_row(database, layer_table(),
                 {layer.top, layer.bottom, study.baseline.soils[layer.soil].name, ++position});
  else
    for (const solver::ProgramOutput& output : external->outputs)
      insert_row(database, output_table(),
                 {output.name, output.unit, output.meaning, output.over, output.over_unit, ++position});
  position = 0;
  for (const parameters::Row& row : study.rows) {
    const solver::Quantity& q = *row.quantity;
    insert_row(
        database, parameter_table(),
        {q.name, std::string(q.symbol), std::string(q.unit), std::string(q.meaning), row.baseline, row.lower,
         row.upper, q.format(row.baseline), q.format(row.lower), q.format(row.upper), ++position});
  }
  position = 0;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const parameters::Window& window : study.windows)
    insert_row(
        database, window_table(),
        {window.name, std::string(kind_name(window.kind)), none, none, "", ++position, window.from, window.to,
         window.width > 0.0 ? window.width : none, window.output, unit_of(external, window.output)});
}

void write_inputs(const Database& database, const parameters::Study& study,
                  std::span<const parameters::Realization> realizations) {
  const std::vector<const solver::Quantity*> varied = parameters::varied_quantities(study);
  database.execute("DELETE FROM realization_input");
  for (const parameters::Realization& realization : realizations) {
    const solver::Setup setup = parameters::make_setup(study, realization);
    for (const solver::Quantity* quantity : varied) {
      const double value = quantity->value(setup);
      insert_row(database, input_table(), {realization.id, quantity->name, value, quantity->format(value)});
    }
  }
}

void write_outcome(const Database& database, int id, const solver::Outcome& outcome) {
  if (!solver::is_even(outcome.profile))
    throw std::logic_error(fmt::format("realization {}: the arrays of its profile differ in length", id));
  RealizationRow row;
  row.status = solver::to_string(outcome.status);
  row.reason = outcome.reason;
  row.wall_s = outcome.wall_seconds;
  row.steps = outcome.steps;
  row.material_points = outcome.material_points;
  row.finished = utc_now();
  row.audit = outcome.audit;
  std::vector<const RowColumn<RealizationRow>*> changed;
  std::string changes;
  for (const RowColumn<RealizationRow>& column : run_table(in_use_tables).columns)
    if (is_outcome(column) && column.name != "started") {
      changes += (changed.empty() ? "" : ", ") + column.name + " = ?";
      changed.push_back(&column);
    }
  Statement update = database.prepare(fmt::format("UPDATE realization SET {} WHERE id = ?", changes));
  for (const RowColumn<RealizationRow>* column : changed) column->bind(update, row);
  update.bind(id).run();
  if (!outcome.profile.is_empty()) insert_row(database, curve_table(in_use_tables), {id, outcome.profile});
  database.prepare("INSERT INTO checksum VALUES (?, ?)").bind(id).bind(outcome_checksum(database, id)).run();
}

solver::DepthProfile read_profile(const Database& database, std::int64_t id, const RunTables& tables) {
  Statement row = select_rows(database, curve_table(tables), "WHERE realization = ?");
  row.bind(id);
  if (!row.step()) return {};
  CurveRow curve = row_of(curve_table(tables), row);
  check_curve(database, curve);
  return std::move(curve.profile);
}

namespace {

// nullptr where the program gave no such output.
const solver::ProgramResult* declared(const solver::DepthProfile& profile, const std::string& output) {
  const auto found = std::ranges::find(profile.declared, output, &solver::ProgramResult::name);
  return found == profile.declared.end() ? nullptr : &*found;
}

void write_output_mean(const Database& database, int id, const std::string& window, const Interval& interval,
                       const solver::ProgramResult* result) {
  const Resolved<WindowMean> mean = result ? average(*result, interval) : Resolved<WindowMean>{{}, "none"};
  if (!mean) return;
  WindowMeanRow row{id,
                    window,
                    interval.from,
                    interval.to,
                    mean.value.mean,
                    mean.value.min,
                    mean.value.max,
                    mean.value.bins,
                    {}};
  row.other_means_kPa.fill(std::numeric_limits<double>::quiet_NaN());
  insert_row(database, window_mean_table(), row);
}

}  // namespace

void write_window_means(const Database& database, int id, const solver::DepthProfile& profile) {
  Statement windows =
      database.prepare("SELECT name, from_m, to_m, output FROM depth_window WHERE from_m IS NOT NULL");
  while (windows.step()) {
    const Interval interval{windows.number(1), windows.number(2)};
    if (const std::string output = windows.text(3); !output.empty()) {
      write_output_mean(database, id, windows.text(0), interval, declared(profile, output));
      continue;
    }
    const Resolved<WindowMean> mean = average(profile, interval);
    if (!mean) continue;  // the view `sensitivity` then says so
    WindowMeanRow row{id,
                      windows.text(0),
                      interval.from,
                      interval.to,
                      mean.value.mean / Pa_per_kPa,
                      mean.value.min / Pa_per_kPa,
                      mean.value.max / Pa_per_kPa,
                      mean.value.bins,
                      {}};
    for (std::size_t k = 1; k < solver::channel_count; ++k)
      row.other_means_kPa[k - 1] = channel_average(profile, solver::channels()[k], interval) / Pa_per_kPa;
    insert_row(database, window_mean_table(), row);
  }
}

void recompute_windows(const Database& database, const parameters::Study& study) {
  database.execute("DELETE FROM window_mean");
  for (const parameters::Window& window : study.windows) {
    const Resolved<Interval> interval = place(window, database);
    const double none = std::numeric_limits<double>::quiet_NaN();
    database.prepare("UPDATE depth_window SET from_m = ?, to_m = ?, problem = ? WHERE name = ?")
        .bind(interval ? interval.value.from : none)
        .bind(interval ? interval.value.to : none)
        .bind(interval.problem)
        .bind(window.name)
        .run();
  }
  std::vector<int> completed;
  Statement rows = database.prepare("SELECT id FROM realization WHERE status = 'completed' ORDER BY id");
  while (rows.step()) completed.push_back(static_cast<int>(rows.integer(0)));
  for (const int id : completed) write_window_means(database, id, read_profile(database, id));
  recompute_repeat_noise(database);
}

void recompute_repeat_noise(const Database& database) {
  database.execute("DELETE FROM repeat_noise");
  std::map<std::string, std::vector<double>> averages;  // by window
  Statement rows = database.prepare(
      "SELECT m.window, m.q_c_mean_kPa FROM window_mean AS m JOIN realization AS r ON r.id = m.realization "
      "WHERE r.side IN ('baseline', 'repeat') ORDER BY m.window, r.id");
  while (rows.step()) averages[rows.text(0)].push_back(rows.number(1));
  for (const auto& [window, numbers] : averages)
    if (const auto noise = repeat_noise(numbers); noise && noise->mean > 0.0)
      insert_row(database, repeat_noise_table(),
                 {window, noise->runs, noise->mean, noise->deviation, index_half_width(*noise)});
}

}  // namespace cpt::results

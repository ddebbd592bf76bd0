#include "results/ledger/ledger_rows.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "results/ledger/provenance.hpp"
#include "results/statistics/repeat_noise.hpp"
#include "results/statistics/windows.hpp"

namespace cpt::results {
namespace {

constexpr double Pa_per_kPa = 1.0e3;

/// The window's place, or why it has none yet.
Resolved<Interval> place(const parameters::Window& window, const Database& database) {
  if (window.kind == parameters::Window::Kind::fixed) return resolve_window(window, {});
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

std::string_view kind_name(parameters::Window::Kind kind) {
  switch (kind) {
    case parameters::Window::Kind::peak:
      return "peak";
    case parameters::Window::Kind::trough:
      return "trough";
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
  Statement row = database.prepare(fmt::format(
      "SELECT settings_hash, solver_version, status, reason, steps, material_points, max_empty_cells, "
      "wall_s, "
      "mass_error, momentum_error, energy_error, kinetic_fraction, min_time_step_s, max_time_step_s "
      "FROM {} WHERE id = ?",
      tables.run));
  row.bind(id);
  if (row.step())
    for (int column = 0; column < row.columns(); ++column) {
      if (row.is_null(column))
        append("NULL");
      else if (column < 4)
        append(row.text(column));
      else if (column < 7)
        append_bytes(bytes, row.integer(column));
      else
        append_bytes(bytes, row.number(column));
    }
  const solver::DepthProfile profile = read_profile(database, id, tables);
  for (const std::vector<double>* values : {&profile.depth, &profile.q_c, &profile.f_s}) {
    append_bytes(bytes, values->size());
    for (const double value : *values) append_bytes(bytes, value);
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
          parameters::parameter_value(study, realization), parameters::value_text(study, realization),
          settings_hash(parameters::make_setup(study, realization))};
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
      .bind(solver::solver_version())
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
  database
      .prepare(
          "UPDATE realization SET status = 'pending', reason = '', wall_s = NULL, steps = NULL, "
          "material_points = NULL, started = NULL, finished = NULL, mass_error = NULL, momentum_error = "
          "NULL, "
          "energy_error = NULL, kinetic_fraction = NULL, max_empty_cells = NULL, min_time_step_s = NULL, "
          "max_time_step_s = NULL WHERE id = ?")
      .bind(id)
      .run();
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
  database
      .prepare(
          "INSERT INTO campaign VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (one) DO UPDATE SET "
          "name = excluded.name, title = excluded.title, profile = excluded.profile, preset = "
          "excluded.preset, "
          "study_text = excluded.study_text, baseline_setup = excluded.baseline_setup, program_version = "
          "excluded.program_version, solver_version = excluded.solver_version, curve_file = "
          "excluded.curve_file")
      .bind(study.name)
      .bind(study.title)
      .bind(solver::to_string(study.profile))
      .bind(solver::to_string(study.preset))
      .bind(study_text)
      .bind(solver::canonical_text(study.baseline))
      .bind(program_version())
      .bind(solver::solver_version())
      .bind(study.curves.filename().string())
      .bind(utc_now())
      .run();

  database.execute(
      "DELETE FROM layer; DELETE FROM parameter; DELETE FROM window_mean; DELETE FROM repeat_noise; "
      "DELETE FROM depth_window");
  int position = 0;
  for (const solver::Layer& layer : study.baseline.layers)
    database.prepare("INSERT INTO layer VALUES (?, ?, ?, ?)")
        .bind(++position)
        .bind(layer.top)
        .bind(layer.bottom)
        .bind(study.baseline.soils[layer.soil].name)
        .run();
  position = 0;
  for (const parameters::Row& row : study.rows)
    database.prepare("INSERT INTO parameter VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(row.quantity->name)
        .bind(++position)
        .bind(row.quantity->symbol)
        .bind(row.quantity->unit)
        .bind(row.quantity->meaning)
        .bind(row.baseline)
        .bind(row.lower)
        .bind(row.upper)
        .bind(row.quantity->format(row.baseline))
        .bind(row.quantity->format(row.lower))
        .bind(row.quantity->format(row.upper))
        .run();
  position = 0;
  for (const parameters::Window& window : study.windows)
    database
        .prepare(
            "INSERT INTO depth_window (name, position, kind, search_from_m, search_to_m, width_m, problem) "
            "VALUES (?, ?, ?, ?, ?, ?, '')")
        .bind(window.name)
        .bind(++position)
        .bind(kind_name(window.kind))
        .bind(window.from)
        .bind(window.to)
        .bind(window.kind == parameters::Window::Kind::fixed ? std::numeric_limits<double>::quiet_NaN()
                                                             : window.width)
        .run();
}

void write_outcome(const Database& database, int id, const solver::Outcome& outcome) {
  const solver::Audit& audit = outcome.audit;
  database
      .prepare(
          "UPDATE realization SET status = ?, reason = ?, wall_s = ?, steps = ?, material_points = ?, "
          "finished = ?, mass_error = ?, momentum_error = ?, energy_error = ?, kinetic_fraction = ?, "
          "max_empty_cells = ?, min_time_step_s = ?, max_time_step_s = ? WHERE id = ?")
      .bind(solver::to_string(outcome.status))
      .bind(outcome.reason)
      .bind(outcome.wall_seconds)
      .bind(outcome.steps)
      .bind(outcome.material_points)
      .bind(utc_now())
      .bind(audit.mass_error)
      .bind(audit.momentum_error)
      .bind(audit.energy_error)
      .bind(audit.kinetic_fraction)
      .bind(audit.max_empty_cells)
      .bind(audit.min_time_step)
      .bind(audit.max_time_step)
      .bind(id)
      .run();
  const solver::DepthProfile& profile = outcome.profile;
  if (profile.depth.size() != profile.q_c.size() || profile.depth.size() != profile.f_s.size())
    throw std::logic_error(fmt::format("realization {}: the arrays of its profile differ in length", id));
  if (!profile.depth.empty())
    database.prepare("INSERT INTO curve VALUES (?, ?, ?, ?, ?)")
        .bind(id)
        .bind(static_cast<std::int64_t>(profile.depth.size()))
        .bind(profile.depth)
        .bind(profile.q_c)
        .bind(profile.f_s)
        .run();
  database.prepare("INSERT INTO checksum VALUES (?, ?)").bind(id).bind(outcome_checksum(database, id)).run();
}

solver::DepthProfile read_profile(const Database& database, std::int64_t id, const RunTables& tables) {
  Statement row = database.prepare(
      fmt::format("SELECT depth_m, q_c_Pa, f_s_Pa FROM {} WHERE realization = ?", tables.curve));
  row.bind(id);
  if (!row.step()) return {};
  solver::DepthProfile profile{row.doubles(0), row.doubles(1), row.doubles(2)};
  if (profile.q_c.size() != profile.depth.size() || profile.f_s.size() != profile.depth.size())
    fail_damaged(database.file(),
                 fmt::format("the curve of realization {} has columns of different lengths", id));
  return profile;
}

void write_window_means(const Database& database, int id, const solver::DepthProfile& profile) {
  Statement windows =
      database.prepare("SELECT name, from_m, to_m FROM depth_window WHERE from_m IS NOT NULL");
  while (windows.step()) {
    const Interval interval{windows.number(1), windows.number(2)};
    const Resolved<WindowMean> mean = average(profile, interval);
    if (!mean) continue;  // the view `sensitivity` then says so
    database.prepare("INSERT INTO window_mean VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(id)
        .bind(windows.text(0))
        .bind(interval.from)
        .bind(interval.to)
        .bind(mean.value.bins)
        .bind(mean.value.mean / Pa_per_kPa)
        .bind(mean.value.min / Pa_per_kPa)
        .bind(mean.value.max / Pa_per_kPa)
        .run();
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
      database.prepare("INSERT INTO repeat_noise VALUES (?, ?, ?, ?, ?)")
          .bind(window)
          .bind(noise->runs)
          .bind(noise->mean)
          .bind(noise->deviation)
          .bind(index_half_width(*noise))
          .run();
}

}  // namespace cpt::results

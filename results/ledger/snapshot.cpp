#include "results/ledger/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "results/files/database.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/interrupted.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/schema.hpp"

namespace cpt::results {
namespace {

RealizationRow realization_row(const Database& database, const Statement& row) {
  RealizationRow r;
  if (row.integer(0) < 1 || row.integer(0) > std::numeric_limits<int>::max())
    fail_damaged(database.file(), fmt::format("a realization has the number {}", row.integer(0)));
  r.id = static_cast<int>(row.integer(0));
  r.parameter = row.text(1);
  r.side = row.text(2);
  r.value = row.number(3);
  r.value_text = row.text(4);
  r.status = row.text(5);
  r.reason = row.text(6);
  r.wall_s = row.number(7);
  r.steps = row.integer(8);
  r.material_points = row.integer(9);
  r.settings_hash = row.text(10);
  r.solver_version = row.text(11);
  r.started = row.text(12);
  r.finished = row.text(13);
  r.audit = {
      row.number(14), row.number(15), row.number(16), row.number(17), static_cast<int>(row.integer(18)),
      row.number(19), row.number(20)};
  return r;
}

void read_description(const Database& database, Snapshot& s) {
  Statement campaign = database.prepare(
      "SELECT name, title, profile, preset, study_text, baseline_setup, program_version, solver_version, "
      "created, "
      "curve_file FROM campaign");
  if (!campaign.step()) throw Error(database.file().string() + ": the ledger names no campaign");
  s.campaign = {campaign.text(0), campaign.text(1), campaign.text(2), campaign.text(3), campaign.text(4),
                campaign.text(5), campaign.text(6), campaign.text(7), campaign.text(8), campaign.text(9)};
  Statement layers = database.prepare("SELECT top_m, bottom_m, soil FROM layer ORDER BY position");
  while (layers.step()) s.layers.push_back({layers.number(0), layers.number(1), layers.text(2)});
  Statement rows = database.prepare(
      "SELECT name, symbol, unit, meaning, baseline, lower, upper, baseline_text, lower_text, upper_text "
      "FROM parameter ORDER BY position");
  while (rows.step())
    s.parameters.push_back({rows.text(0), rows.text(1), rows.text(2), rows.text(3), rows.number(4),
                            rows.number(5), rows.number(6), rows.text(7), rows.text(8), rows.text(9)});
  Statement windows =
      database.prepare("SELECT name, kind, from_m, to_m, problem FROM depth_window ORDER BY position");
  while (windows.step())
    s.windows.push_back(
        {windows.text(0), windows.text(1), windows.number(2), windows.number(3), windows.text(4)});
}

void read_numbers(const Database& database, Snapshot& s) {
  Statement rows = database.prepare(fmt::format("SELECT id, {} FROM realization ORDER BY id", run_columns));
  while (rows.step()) s.realizations.push_back(realization_row(database, rows));
  Statement means = database.prepare(
      "SELECT realization, m.window, m.from_m, m.to_m, q_c_mean_kPa, q_c_min_kPa, q_c_max_kPa FROM "
      "window_mean AS m "
      "JOIN depth_window AS w ON w.name = m.window ORDER BY realization, w.position");
  while (means.step())
    s.window_means.push_back({static_cast<int>(means.integer(0)), means.text(1), means.number(2),
                              means.number(3), means.number(4), means.number(5), means.number(6)});
  Statement audit = database.prepare("SELECT realization, out_of_line FROM audit WHERE out_of_line <> ''");
  while (audit.step()) {
    const auto row = std::ranges::lower_bound(s.realizations, audit.integer(0), {}, &RealizationRow::id);
    if (row != s.realizations.end() && row->id == audit.integer(0)) row->out_of_line = audit.text(1);
  }
  Statement noise = database.prepare(
      "SELECT window, runs, q_c_mean_kPa, q_c_deviation_kPa, si_half_width FROM repeat_noise ORDER BY "
      "window");
  while (noise.step())
    s.repeat_noise.push_back({noise.text(0), static_cast<int>(noise.integer(1)), noise.number(2),
                              noise.number(3), noise.number(4)});
  Statement si = database.prepare(
      "SELECT window, parameter, q_lower_kPa, q_upper_kPa, q_baseline_kPa, si, si_abs, si_noise, "
      "above_noise, note, si_half_width, above_repeats, above_si_noise, pairs FROM sensitivity");
  const auto flag = [&](int column) {
    return si.is_null(column) ? std::nullopt : std::optional(si.integer(column) != 0);
  };
  while (si.step())
    s.sensitivity.push_back({si.text(0), si.text(1), si.number(2), si.number(3), si.number(4), si.number(5),
                             si.number(6), si.number(7), flag(8), si.number(10), flag(11), flag(12),
                             static_cast<int>(si.integer(13)), si.text(9)});
  Statement curves = database.prepare("SELECT realization FROM curve ORDER BY realization");
  while (curves.step()) {
    const int id = static_cast<int>(curves.integer(0));
    s.curves.push_back({id, read_profile(database, id)});
  }
  if (database.integer("PRAGMA user_version") < 4) return;  // earlier ledgers were never imported
  Statement imports = database.prepare("SELECT file, sha256, imported FROM import ORDER BY position");
  while (imports.step()) s.imports.push_back({imports.text(0), imports.text(1), imports.text(2)});
}

/// A row that another one refers to is there; who reads a snapshot relies on it.
void refuse_dangling(const Database& database, const Snapshot& s) {
  std::set<int> realizations;
  std::set<std::string> parameters, windows;
  for (const RealizationRow& row : s.realizations) realizations.insert(row.id);
  for (const ParameterRow& row : s.parameters) parameters.insert(row.name);
  for (const WindowRow& row : s.windows) windows.insert(row.name);
  const auto require = [&](bool there, std::string_view what) {
    if (!there) fail_damaged(database.file(), what);
  };
  for (const RealizationRow& row : s.realizations)
    if (row.side == "lower" || row.side == "upper")
      require(parameters.contains(row.parameter), "a realization's parameter is not there");
  for (const CurveRow& row : s.curves)
    require(realizations.contains(row.realization), "a curve's realization is not there");
  for (const WindowMeanRow& row : s.window_means)
    require(realizations.contains(row.realization), "an average's realization is not there");
  for (const SensitivityRow& row : s.sensitivity)
    require(parameters.contains(row.parameter) && windows.contains(row.window),
            "an index's parameter or window is not there");
}

}  // namespace

void tell_interrupted(Snapshot& s) {
  for (RealizationRow& row : s.realizations) {
    if (row.status != "running") continue;
    row.status = "pending";
    row.reason = was_interrupted;
  }
  constexpr std::string_view running = " run running", interrupted = " run interrupted";
  for (SensitivityRow& row : s.sensitivity)
    for (std::size_t at = 0; (at = row.note.find(running, at)) != std::string::npos; at += interrupted.size())
      row.note.replace(at, running.size(), interrupted);
}

Snapshot read_snapshot(const std::filesystem::path& file) {
  // Before the rows: who lets go in between has first written what became of them.
  const bool under_way = is_held(file.string() + ".lock");
  const Database database = open_ledger(file);
  const Transaction transaction(database, Transaction::Kind::read);
  Snapshot snapshot = read_snapshot(database);
  if (!under_way) tell_interrupted(snapshot);
  return snapshot;
}

Snapshot read_snapshot(const Database& database) {
  Snapshot snapshot;
  read_description(database, snapshot);
  read_numbers(database, snapshot);
  refuse_dangling(database, snapshot);
  return snapshot;
}

std::optional<StoredRun> read_run(const std::filesystem::path& file, int id) {
  const Database database = open_ledger(file);
  const Transaction transaction(database, Transaction::Kind::read);
  return read_run(database, id);
}

std::optional<StoredRun> read_run(const Database& database, int id) {
  return read_run(database, id, in_use_tables);
}

std::optional<StoredRun> read_run(const Database& database, int id, const RunTables& tables) {
  Statement row =
      database.prepare(fmt::format("SELECT id, {} FROM {} WHERE id = ?", run_columns, tables.run));
  row.bind(id);
  if (!row.step()) return std::nullopt;
  StoredRun run{realization_row(database, row), std::nullopt};
  solver::DepthProfile profile = read_profile(database, id, tables);
  if (!profile.depth.empty()) run.profile = std::move(profile);
  return run;
}

}  // namespace cpt::results

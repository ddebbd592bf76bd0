#include "results/ledger/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "results/files/database.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/interrupted.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/ledger_tables.hpp"
#include "results/ledger/old_inputs.hpp"
#include "results/ledger/schema.hpp"

namespace cpt::results {
namespace {

void check_number(const Database& database, const RealizationRow& row) {
  if (row.id < 1) fail_damaged(database.file(), fmt::format("a realization has the number {}", row.id));
}

std::vector<SensitivityRow> read_sensitivity(const Database& database) {
  std::vector<SensitivityRow> rows;
  Statement si = database.prepare(
      "SELECT window, parameter, q_lower_kPa, q_upper_kPa, q_baseline_kPa, si, si_abs, si_noise, "
      "above_noise, note, si_half_width, above_repeats, above_si_noise, pairs FROM sensitivity");
  const auto flag = [&](int column) {
    return si.is_null(column) ? std::nullopt : std::optional(si.integer(column) != 0);
  };
  while (si.step())
    rows.push_back({si.text(0), si.text(1), si.number(2), si.number(3), si.number(4), si.number(5),
                    si.number(6), si.number(7), flag(8), si.number(10), flag(11), flag(12),
                    static_cast<int>(si.integer(13)), si.text(9)});
  return rows;
}

void read_audit(const Database& database, std::vector<RealizationRow>& runs) {
  Statement audit = database.prepare("SELECT realization, out_of_line FROM audit WHERE out_of_line <> ''");
  while (audit.step()) {
    const auto row = std::ranges::lower_bound(runs, audit.integer(0), {}, &RealizationRow::id);
    if (row != runs.end() && row->id == audit.integer(0)) row->out_of_line = audit.text(1);
  }
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
  std::vector<CampaignRow> campaigns = read_rows(database, campaign_table());
  if (campaigns.empty()) throw Error(database.file().string() + ": the ledger names no campaign");
  snapshot.campaign = std::move(campaigns.front());
  snapshot.layers = read_rows(database, layer_table());
  snapshot.parameters = read_rows(database, parameter_table());
  snapshot.windows = read_rows(database, window_table());
  snapshot.realizations = read_rows(database, run_table(in_use_tables));
  for (const RealizationRow& row : snapshot.realizations) check_number(database, row);
  read_audit(database, snapshot.realizations);
  snapshot.window_means = read_rows(database, window_mean_table());
  snapshot.repeat_noise = read_rows(database, repeat_noise_table());
  snapshot.sensitivity = read_sensitivity(database);
  snapshot.curves = read_rows(database, curve_table(in_use_tables));
  for (const CurveRow& curve : snapshot.curves) check_curve(database, curve);
  snapshot.outputs = read_rows(database, output_table());
  snapshot.imports = read_rows(database, import_table());
  snapshot.inputs = read_rows(database, input_table());
  if (snapshot.inputs.empty()) snapshot.inputs = inputs_of_texts(snapshot);
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
  Statement row = select_rows(database, run_table(tables), "WHERE id = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  StoredRun run{row_of(run_table(tables), row), std::nullopt};
  check_number(database, run.row);
  solver::DepthProfile profile = read_profile(database, id, tables);
  if (!profile.is_empty()) run.profile = std::move(profile);
  return run;
}

}  // namespace cpt::results

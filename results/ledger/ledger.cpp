#include "results/ledger/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "results/files/database.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/effect_tables.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/matching.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/salvage.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/ledger/study_changes.hpp"
#include "results/ledger/unused_rows.hpp"

namespace cpt::results {
namespace {

/// SQLite reads over much of what a failing disk does to a file; it is asked to look.
void refuse_damaged(const Database& database) {
  Statement check = database.prepare("PRAGMA integrity_check(1)");
  if (!check.step() || check.text(0) != "ok") fail_damaged(database.file(), check.text(0));
  if (database.prepare("PRAGMA foreign_key_check").step())
    fail_damaged(database.file(), "a row refers to one that is not there");
}

/// Imported results are not this program's runs, whatever settings they name: a campaign neither goes on
/// with them nor takes them over.
void refuse_imported(const Database& database) {
  if (database.integer("PRAGMA user_version") < 4) return;  // earlier ledgers were never imported
  Statement row = database.prepare("SELECT file, imported FROM import ORDER BY position");
  if (!row.step()) return;
  throw Error(fmt::format(
      "{}: holds results imported from {} ({}), which are not runs of this program; give the study "
      "another database ([output] database = ...), or move this one away",
      database.file().string(), row.text(0), row.text(1)));
}

/// A study whose name differs and that shares no run with the database is most likely a mistyped file name.
void refuse_other_study(const Database& database, const parameters::Study& study, const Opened& opened) {
  Statement row = database.prepare("SELECT name FROM campaign");
  if (!row.step() || row.text(0) == study.name || opened.kept > 0 || opened.set_aside == 0) return;
  throw Error(
      fmt::format("{}: holds {} finished realizations of the study '{}' and none of '{}'; name another "
                  "database, or move this one away",
                  database.file().string(), opened.set_aside, row.text(0), study.name));
}

}  // namespace

struct Ledger::State {
  std::unique_ptr<FileLock> lock;  // before the database, so that it is released after it is closed
  Database database;
  parameters::Study study;
  Opened opened;
  bool grouped = false;
  std::optional<Transaction> group = {};  // once something is written in it
};

/// One write, or a part of the group that is open.
class Ledger::Write {
 public:
  explicit Write(State& state) {
    std::optional<Transaction>& transaction = state.grouped ? state.group : own_;
    if (!transaction) transaction.emplace(state.database, Transaction::Kind::write);
  }
  void commit() {
    if (own_) own_->commit();
  }

 private:
  std::optional<Transaction> own_;
};

Ledger::Group::Group(Ledger& ledger) : ledger_(ledger) { ledger_.state_->grouped = true; }

Ledger::Group::~Group() {
  ledger_.state_->group.reset();
  ledger_.state_->grouped = false;
}

void Ledger::Group::commit() {
  std::optional<Transaction>& group = ledger_.state_->group;
  if (group) group->commit();
  group.reset();
}

Ledger::Ledger(std::unique_ptr<State> state) : state_(std::move(state)) {}
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;

Ledger::~Ledger() {
  if (state_ == nullptr) return;
  try {
    // Leaves one plain file that opens from read-only media too. Not possible while a reader has it open.
    state_->database.execute("PRAGMA busy_timeout = 0; PRAGMA journal_mode = DELETE");
  } catch (const Error&) {
  }
}

Ledger Ledger::open_for_run(const parameters::Study& study,
                            std::span<const parameters::Realization> realizations,
                            const RunOptions& options) {
  const std::filesystem::path& file = study.database;
  if (file.has_parent_path() && !std::filesystem::is_directory(file.parent_path()))
    throw Error(fmt::format("{}: the folder {} does not exist", file.string(), file.parent_path().string()));
  auto lock = std::make_unique<FileLock>(file.string() + ".lock");
  try {
    return open(study, realizations, options, lock);
  } catch (const Damaged&) {
    const std::filesystem::path aside = set_aside(file);
    Ledger ledger = open(study, realizations, options, lock);
    const int saved =
        ledger.save(salvage(aside, 2 * static_cast<int>(realizations.size()) + 1000), !options.retry_failed);
    Opened& opened = ledger.state_->opened;
    std::string message = fmt::format(
        "the database was damaged and is kept as {}; realizations saved from it: {}", aside.string(), saved);
    if (opened.unused > 0)
      message += fmt::format(", and {} finished ones that the study does not ask for", opened.unused);
    if (options.tell) options.tell(message);
    opened.messages.push_back(std::move(message));
    return ledger;
  }
}

Ledger Ledger::open(const parameters::Study& study, std::span<const parameters::Realization> realizations,
                    const RunOptions& options, std::unique_ptr<FileLock>& lock) {
  const std::filesystem::path& file = study.database;
  Database database(file, Database::Mode::read_write);
  const bool created = is_empty(database);
  if (!created) check_schema(database);
  if (!created) refuse_imported(database);
  if (!created) refuse_damaged(database);
  const FileSystem system = options.file_system.value_or(file_system_of(file));
  database.execute(fmt::format("PRAGMA journal_mode = {}; PRAGMA synchronous = FULL", journal_mode(system)));

  Transaction transaction(database, Transaction::Kind::write);
  database.execute("PRAGMA defer_foreign_keys = ON");
  if (created)
    create_schema(database);
  else
    upgrade_schema(database);
  mend_views(database);
  const std::vector<std::string> changes = study_changes(database, study);
  const Matching matching = match(database, study, realizations);
  Opened opened = describe(matching, changes, created, options.retry_failed);
  refuse_other_study(database, study, opened);
  if (options.tell)
    for (const std::string& message : opened.messages) options.tell(message);
  apply(database, matching, options.retry_failed);
  write_study(database, study, options.study_text);
  write_inputs(database, study, realizations);
  recompute_windows(database, study);
  opened.pending =
      static_cast<int>(database.integer("SELECT count(*) FROM realization WHERE status = 'pending'"));
  transaction.commit();
  return Ledger(
      std::unique_ptr<State>(new State{std::move(lock), std::move(database), study, std::move(opened)}));
}

const Opened& Ledger::opened() const { return state_->opened; }

std::filesystem::path Ledger::path() const { return state_->database.file(); }

Counts Ledger::counts() const {
  Counts counts;
  Statement rows = state_->database.prepare("SELECT status, count(*) FROM realization GROUP BY status");
  while (rows.step()) {
    const std::string status = rows.text(0);
    int& count = status == "pending"      ? counts.pending
                 : status == "running"    ? counts.running
                 : status == "completed"  ? counts.completed
                 : status == "not_needed" ? counts.not_needed
                                          : counts.failed;
    count += static_cast<int>(rows.integer(1));
  }
  return counts;
}

std::vector<int> Ledger::pending() const {
  std::vector<int> ids;
  Statement rows =
      state_->database.prepare("SELECT id FROM realization WHERE status = 'pending' ORDER BY id");
  while (rows.step()) ids.push_back(static_cast<int>(rows.integer(0)));
  return ids;
}

std::string Ledger::settings_hash(int id) const {
  Statement row = state_->database.prepare("SELECT settings_hash FROM realization WHERE id = ?");
  row.bind(id);
  if (!row.step()) throw std::logic_error(fmt::format("the ledger has no realization {}", id));
  return row.text(0);
}

int Ledger::adopt(const std::filesystem::path& other) {
  if (!std::filesystem::exists(other)) return 0;
  return take(completed_runs(other), false);
}

int Ledger::take(const std::vector<StoredRun>& finished, bool failed_too) {
  const Database& database = state_->database;
  std::map<std::string, int> pending;
  {
    Statement rows = database.prepare("SELECT id, settings_hash FROM realization WHERE status = 'pending'");
    while (rows.step()) pending[rows.text(1)] = static_cast<int>(rows.integer(0));
  }
  Write write(*state_);
  int taken = 0;
  for (const StoredRun& run : finished) {
    const auto same = pending.find(run.row.settings_hash);
    if (same == pending.end() || (run.row.failed() && !failed_too)) continue;
    replace_run(database, same->second, run);
    pending.erase(same);
    ++taken;
  }
  if (taken > 0) recompute_windows(database, state_->study);
  write.commit();
  return taken;
}

int Ledger::save(const Salvage& salvaged, bool failed_too) {
  Group group(*this);
  const int saved = take(salvaged.runs, failed_too);
  const int aside = keep_salvaged(state_->database, salvaged);
  group.commit();
  Opened& opened = state_->opened;
  opened.unused = aside;
  opened.pending -= saved;
  const Counts now = counts();
  opened.kept = now.completed;
  opened.failed = now.failed;
  return saved;
}

void Ledger::mark_running(int id) {
  Write write(*state_);
  require_waiting(state_->database, id);
  state_->database.prepare("UPDATE realization SET status = 'running', started = ? WHERE id = ?")
      .bind(utc_now())
      .bind(id)
      .run();
  write.commit();
}

void Ledger::mark_pending(int id) {
  Write write(*state_);
  require_waiting(state_->database, id);
  clear_outcome(state_->database, id);
  write.commit();
}

void Ledger::mark_not_needed(std::span<const int> ids) {
  Write write(*state_);
  for (const int id : ids) {
    require_waiting(state_->database, id);
    state_->database.prepare("UPDATE realization SET status = 'not_needed' WHERE id = ?").bind(id).run();
  }
  write.commit();
}

void Ledger::write_effects() {
  if (state_->study.design.kind == parameters::Design().kind) return;
  Write write(*state_);
  results::write_effects(state_->database, design_effects(read_snapshot(state_->database)));
  write.commit();
}

void Ledger::record(int id, const solver::Outcome& outcome) {
  const Database& database = state_->database;
  Write write(*state_);
  require_waiting(database, id);
  write_outcome(database, id, outcome);
  Statement row = database.prepare("SELECT side FROM realization WHERE id = ?");
  row.bind(id);
  const std::string side = row.step() ? row.text(0) : "";
  if (side == "baseline") {
    recompute_windows(database, state_->study);
  } else if (outcome.status == solver::Status::completed) {
    write_window_means(database, id, outcome.profile);
    if (side == "repeat") recompute_repeat_noise(database);
  }
  write.commit();
}

}  // namespace cpt::results

#include "results/ledger/matching.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

#include "parameters/all_realizations.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/run_tables.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/study_changes.hpp"
#include "results/ledger/unused_rows.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {
namespace {

/// How a stored run enters a new campaign.
enum class Fate { keep_completed, keep_failed, wait, running, interrupted, retry, damaged };

Fate fate_of(const HeldRun& run, bool retry_failed, bool under_way = false) {
  if (run.damaged) return Fate::damaged;
  if (run.status == "completed") return Fate::keep_completed;
  if (run.status == "pending" || run.status == "not_needed") return Fate::wait;
  if (run.status == "running" && under_way && !run.unused) return Fate::running;
  if (!run.finished()) return Fate::interrupted;
  return retry_failed ? Fate::retry : Fate::keep_failed;
}

std::vector<HeldRun> held_runs(const Database& database) {
  std::vector<HeldRun> runs;
  for (const RunTables* tables : {&in_use_tables, &unused_tables}) {
    if (!has_table(database, tables->run)) continue;  // earlier schema versions
    const bool aside = tables == &unused_tables;
    const bool check = !aside && has_table(database, tables->checksum);
    Statement all = database.prepare(
        fmt::format("SELECT id, settings_hash, status, solver_version FROM {} ORDER BY id", tables->run));
    while (all.step()) {
      const std::int64_t id = all.integer(0);
      const bool damaged = check && matches_checksum(database, id, *tables) == std::optional(false);
      runs.push_back({id, aside, all.text(1), all.text(2), all.text(3), damaged});
    }
  }
  return runs;
}

/// The smaller, the sooner it is taken.
int rank(const HeldRun& run) {
  if (run.damaged) return 3;
  return run.status == "completed" ? 0 : run.finished() ? 1 : 2;
}

std::string runs(int count, std::string_view what) {
  return fmt::format("{} {} {}", count, count == 1 ? "realization" : "realizations", what);
}

}  // namespace

bool HeldRun::finished() const {
  return status != "pending" && status != "running" && status != "rank_lost" && status != "not_needed";
}

Matching match(const Database& database, const parameters::Study& study,
               std::span<const parameters::Realization> realizations) {
  std::vector<HeldRun> held = held_runs(database);
  std::multimap<std::string, std::size_t> free;  // by settings hash; equal ones in the order of their rank
  std::vector<std::size_t> order(held.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rank(held[a]) < rank(held[b]); });
  for (const std::size_t k : order) free.insert({held[k].settings_hash, k});

  Matching matching;
  std::vector<bool> taken(held.size());
  for (const parameters::Realization& realization : realizations) {
    MatchedRun& matched = matching.realizations.emplace_back(
        MatchedRun{realization.id, describe_input(study, realization), std::nullopt});
    const auto found = free.lower_bound(matched.input.settings_hash);
    if (found == free.end() || found->first != matched.input.settings_hash) continue;
    HeldRun& run = held[found->second];
    if (run.unused) run.damaged = matches_checksum(database, run.id, unused_tables) == std::optional(false);
    taken[found->second] = true;
    matched.held = run;
    free.erase(found);
  }
  for (std::size_t k = 0; k < held.size(); ++k)
    if (!taken[k]) matching.left.push_back(std::move(held[k]));
  return matching;
}

Opened describe(const Matching& matching, const std::vector<std::string>& changes, bool created,
                bool retry_failed, bool under_way) {
  Opened opened;
  opened.created = created;
  const std::string present = matching.realizations.empty()
                                  ? std::string(solver::solver_version())
                                  : matching.realizations.front().input.solver_version;
  for (const MatchedRun& realization : matching.realizations) {
    if (!realization.held) {
      ++opened.fresh;
      continue;
    }
    const Fate fate = fate_of(*realization.held, retry_failed, under_way);
    opened.kept += fate == Fate::keep_completed;
    opened.failed += fate == Fate::keep_failed;
    opened.running += fate == Fate::running;
    opened.interrupted += fate == Fate::interrupted;
    opened.retried += fate == Fate::retry;
    opened.damaged += fate == Fate::damaged;
    opened.used_again +=
        realization.held->unused && (fate == Fate::keep_completed || fate == Fate::keep_failed);
  }
  for (const HeldRun& run : matching.left) {
    opened.damaged += run.damaged;
    if (run.damaged || !run.finished()) continue;
    ++opened.unused;
    opened.set_aside += !run.unused;
    if (run.solver_version == present) continue;
    ++opened.of_other_solvers;
    std::vector<std::string>& versions = opened.other_solvers;
    if (std::find(versions.begin(), versions.end(), run.solver_version) == versions.end())
      versions.push_back(run.solver_version);
  }

  const auto say = [&](int count, std::string_view what) {
    if (count > 0) opened.messages.push_back(runs(count, what));
  };
  say(opened.kept, "kept: completed before with the same settings");
  say(opened.failed, "failed before and not run again (--retry-failed runs them)");
  say(opened.used_again, "among these unused until now: the study has their settings again");
  say(opened.running, "running now");
  say(opened.retried, "failed before and to be run again");
  say(opened.interrupted, "interrupted before and to be run again");
  say(opened.damaged,
      "damaged in the database (what is stored does not match its checksum) and to be run again");
  if (!created) say(opened.fresh, "new: not run before with these settings");
  say(opened.unused - opened.of_other_solvers,
      "finished before that fit no row of the study: kept but unused until it has their settings again; only "
      "campaign prune removes them");
  say(opened.of_other_solvers,
      fmt::format("made by solver version {}, this is {}: kept but unused; only campaign prune removes them",
                  fmt::join(opened.other_solvers, ", "), present));
  constexpr std::size_t most = 12;
  for (std::size_t k = 0; k < std::min(most, changes.size()); ++k)
    opened.messages.push_back("the study has changed: " + changes[k]);
  if (changes.size() > most)
    opened.messages.push_back(fmt::format("the study has changed in {} more places", changes.size() - most));
  return opened;
}

std::optional<Prospect> prospect(const parameters::Study& study) {
  std::error_code ignored;
  if (!std::filesystem::exists(study.database, ignored)) return std::nullopt;
  const Database database(study.database, Database::Mode::read_only);
  if (is_empty(database)) return std::nullopt;
  check_schema(database);
  show_as_present(database);
  const std::filesystem::path lock = study.database.string() + ".lock";
  const bool under_way = is_held(lock);  // before the rows, as read_snapshot
  const Transaction transaction(database, Transaction::Kind::read);
  Prospect found{match(database, study, parameters::all_realizations(study)), {}, "", under_way};
  found.opened = describe(found.matching, study_changes(database, study), false, false, under_way);
  if (under_way)
    found.opened.messages.push_back(
        fmt::format("a campaign runs on this database now, {} holds {}: another can start when it has ended",
                    holder_of(lock), lock.filename().string()));
  Statement campaign = database.prepare("SELECT study_text FROM campaign");
  if (campaign.step()) found.stored_text = campaign.text(0);
  return found;
}

void apply(const Database& database, const Matching& matching, bool retry_failed, bool as_found) {
  // Negative ids keep old and new apart while rows are renumbered; curves follow by ON UPDATE CASCADE.
  database.execute("UPDATE realization SET id = -id");
  for (const MatchedRun& realization : matching.realizations) {
    if (!realization.held) {
      insert_pending(database, realization.id, realization.input);
      continue;
    }
    const HeldRun& run = *realization.held;
    if (run.unused)
      use_again(database, run.id, realization.id, realization.input);
    else
      rename_realization(database, -run.id, realization.id, realization.input);
    const Fate fate = fate_of(run, retry_failed);
    // Whether it is needed is found out again.
    const bool asked_again = fate == Fate::interrupted || fate == Fate::retry || fate == Fate::damaged;
    if (run.status == "not_needed" || (!as_found && asked_again)) clear_outcome(database, realization.id);
  }
  for (const HeldRun& run : matching.left)
    if (!run.unused && (run.damaged || !run.finished()))
      database.prepare("DELETE FROM realization WHERE id = ?").bind(-run.id).run();
  keep_unused(database);
  forget_former_studies(database);
}

}  // namespace cpt::results

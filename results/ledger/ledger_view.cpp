#include "results/ledger/ledger_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "parameters/all_realizations.hpp"
#include "results/files/file_lock.hpp"
#include "results/ledger/interrupted.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/matching.hpp"
#include "results/ledger/provenance.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/study_changes.hpp"
#include "results/tables/count_of.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {
namespace {

/// Why the stored results cannot be shown as another study; empty where they can.
std::string obstacle(const Database& database, const std::string& present) {
  if (has_table(database, "import") && database.integer("SELECT count(*) FROM import") > 0)
    return "its results are imported";
  Statement campaign = database.prepare("SELECT solver_version FROM campaign");
  if (!campaign.step() || campaign.text(0) == present) return "";
  return fmt::format("its results are of solver version {}, this is {}", campaign.text(0), present);
}

std::string listed(const std::vector<std::string>& changes) {
  constexpr std::size_t most = 4;
  if (changes.empty()) return "";
  const auto shown = std::vector(
      changes.begin(), changes.begin() + static_cast<std::ptrdiff_t>(std::min(most, changes.size())));
  return fmt::format(" ({}{})", fmt::join(shown, "; "),
                     changes.size() > most ? fmt::format("; {} more", changes.size() - most) : "");
}

}  // namespace

LedgerView view_ledger(const std::filesystem::path& file) {
  const bool under_way = is_held(file.string() + ".lock");  // before the rows, as read_snapshot
  return {open_ledger(file), {}, under_way};
}

LedgerView view_ledger(const parameters::Study& study, const std::string& study_text) {
  LedgerView stored = view_ledger(study.database);
  {
    Statement campaign = stored.database.prepare("SELECT study_text FROM campaign");
    if (!campaign.step() || campaign.text(0) == study_text) return stored;
  }
  const std::string file = study.file.filename().string();
  if (const std::string why = obstacle(stored.database, solver_version(study.baseline)); !why.empty()) {
    stored.notes.push_back(
        fmt::format("{} has been edited since; shown is the study as it is stored, for {}", file, why));
    return stored;
  }

  LedgerView view{stored.database.copy_in_memory(), {}, stored.under_way};
  const Database& database = view.database;
  Transaction transaction(database, Transaction::Kind::write);
  database.execute("PRAGMA defer_foreign_keys = ON");
  upgrade_schema(database);
  mend_views(database);
  const std::vector<std::string> changes = study_changes(database, study);
  const std::vector<parameters::Realization> realizations = parameters::all_realizations(study);
  const Matching matching = match(database, study, realizations);
  const Opened opened = describe(matching, {}, false, false);
  apply(database, matching, false, true);
  write_study(database, study, study_text);
  write_inputs(database, study, realizations);
  recompute_windows(database, study);
  transaction.commit();

  if (changes.empty() && opened.fresh == 0 && opened.set_aside == 0) return view;  // words alone
  view.notes.push_back(fmt::format(
      "{} has been edited since its campaign last ran{}: shown is what it says now, with all averages taken "
      "from the stored curves",
      file, listed(changes)));
  if (opened.fresh > 0)
    view.notes.push_back(fmt::format("of its {}, {} not been run yet: campaign {} does it",
                                     count_of(matching.realizations.size(), "realization"),
                                     opened.fresh == 1 ? "1 has" : fmt::format("{} have", opened.fresh),
                                     file));
  if (opened.set_aside > 0)
    view.notes.push_back(fmt::format("{} it no longer asks for {} left out; nothing is lost",
                                     count_of(static_cast<std::size_t>(opened.set_aside), "stored result"),
                                     opened.set_aside == 1 ? "is" : "are"));
  return view;
}

Snapshot read_snapshot(const LedgerView& view) {
  const Transaction transaction(view.database, Transaction::Kind::read);
  Snapshot snapshot = read_snapshot(view.database);
  if (!view.under_way) tell_interrupted(snapshot);
  return snapshot;
}

}  // namespace cpt::results

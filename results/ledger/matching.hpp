// What a ledger holds of the runs that a study asks for. Runs are the same where their settings hashes are,
// so that adding, removing or reordering rows of a study, or editing it there and back, keeps what is valid.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"
#include "results/files/database.hpp"
#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/opened.hpp"

namespace cpt::results {

/// A run that a ledger holds.
struct HeldRun {
  std::int64_t id = 0;
  bool unused = false;  ///< held among the unused ones
  std::string settings_hash, status, solver_version;
  bool damaged = false;  ///< does not match its checksum; of unused ones not looked at
  /// Whether it ended by itself. A lost rank is an accident of the machine, not a property of the run.
  [[nodiscard]] bool finished() const;
};

/// A realization of the study, and the run that stands for it; none: it is new.
struct MatchedRun {
  int id = 0;
  RealizationInput input;
  std::optional<HeldRun> held;
};

struct Matching {
  std::vector<MatchedRun> realizations;  ///< in the study's order
  std::vector<HeldRun> left;             ///< that fit none: in use until now first, then unused ones
};

/// Reads only. Of several runs with the same settings a completed one is taken first, and one that is in use
/// before an unused one. A database without tables of a ledger holds none.
[[nodiscard]] Matching match(const Database& database, const parameters::Study& study,
                             std::span<const parameters::Realization> realizations);

/// Counts, and says it in sentences, with what was edited in the study (study_changes.hpp). `under_way`: what
/// is marked as running does run, by another campaign.
[[nodiscard]] Opened describe(const Matching& matching, const std::vector<std::string>& changes, bool created,
                              bool retry_failed, bool under_way = false);

/// What a campaign of a study would find in its database.
struct Prospect {
  Matching matching;
  Opened opened;
  std::string stored_text;  ///< of the study as it is stored
  bool under_way = false;   ///< another campaign holds the database's lock
};
/// Reads only; nothing where there is no database. Throws as read_snapshot.
[[nodiscard]] std::optional<Prospect> prospect(const parameters::Study& study);

/// Makes the realizations of the ledger those of the study: what matches under its id, what is left among the
/// unused runs, and pending what is to run. Within a transaction of the caller, who has `describe`d it.
/// `as_found` leaves what is running or damaged as it is, for a look.
void apply(const Database& database, const Matching& matching, bool retry_failed, bool as_found = false);

}  // namespace cpt::results

// The campaign's ledger: one SQLite database with one writer, the campaign's master.
//
// A realization is finished once its transaction (status, audit, curve, window means) is committed with
// synchronous = FULL, so a kill at any moment loses only what was not finished. What ends together may share
// a transaction (Ledger::Group). Readers (snapshot.hpp, query.hpp, or any SQLite browser) may open the
// database at any time, also while the campaign runs. The schema is in docs/schema.md.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"
#include "results/files/error.hpp"
#include "results/files/file_system.hpp"
#include "results/ledger/opened.hpp"
#include "solver/simulate.hpp"

namespace cpt::results {

struct RunOptions {
  std::string study_text;                      ///< the study file as the user wrote it, kept for provenance
  bool retry_failed = false;                   ///< run failed realizations again
  std::optional<FileSystem> file_system = {};  ///< of the database; found out if not given
  /// Is told the sentences of Opened::messages before what they say is written.
  std::function<void(std::string_view)> tell = {};
};

/// Realizations by state.
struct Counts {
  int pending = 0;
  int running = 0;
  int completed = 0;
  int failed = 0;
  int not_needed = 0;  ///< left out by a design that had enough runs; no part of the total
  [[nodiscard]] int total() const { return pending + running + completed + failed; }
};

class FileLock;
struct StoredRun;
struct Salvage;

/// The writer. Not thread-safe. Holds the lock file NAME.sqlite.lock while it lives; the operating system
/// releases the lock if the process is killed.
class Ledger {
 public:
  /// Opens or creates `study.database` for a run of these realizations, which become its rows. Finished runs
  /// are matched by settings hash (matching.hpp); finished ones that the study does not ask for stay in the
  /// database, unused. A damaged database is kept as NAME.damaged, and what is whole in it is taken over.
  /// Throws Locked if another campaign holds it; Error if it is not a ledger, has another schema version,
  /// holds imported results, or finished runs of a differently named study only.
  [[nodiscard]] static Ledger open_for_run(const parameters::Study& study,
                                           std::span<const parameters::Realization> realizations,
                                           const RunOptions& options);
  Ledger(Ledger&&) noexcept;
  Ledger& operator=(Ledger&&) noexcept;
  ~Ledger();

  [[nodiscard]] const Opened& opened() const;
  [[nodiscard]] std::filesystem::path path() const;
  [[nodiscard]] Counts counts() const;

  /// Ids to run, rising.
  [[nodiscard]] std::vector<int> pending() const;
  /// Of a realization's settings (provenance.hpp). Throws std::logic_error if there is no such realization.
  [[nodiscard]] std::string settings_hash(int id) const;
  /// Takes completed realizations of equal settings and solver from another campaign's database as this
  /// one's, unused ones too; returns how many. Nothing if there is no such file, or if its results are
  /// imported.
  int adopt(const std::filesystem::path& other);
  /// A pending realization was handed out.
  void mark_running(int id);
  /// A running realization goes back to pending (its worker was lost and it is to be run elsewhere).
  void mark_pending(int id);
  /// Pending realizations that the design turned out not to need; the next start finds out again.
  void mark_not_needed(std::span<const int> ids);
  /// What the design says of all that has been recorded: for readers of the database, who may read it without
  /// an estimator. Nothing of a study without a design.
  void write_effects();
  /// A realization ended, well or not: status, reason, audit, curve and window means in one transaction, that
  /// of the open group if there is one. The
  /// baseline's record also resolves the peak and trough windows and averages every curve stored before it.
  /// Throws std::logic_error if the realization had already ended.
  void record(int id, const solver::Outcome& outcome);

  /// Group commit: while one lives, what is marked and recorded waits for commit(), which puts all of it on
  /// disk at the price of one; nothing of it is finished before. What is not committed at the end is dropped.
  /// At most one at a time.
  class Group {
   public:
    explicit Group(Ledger& ledger);
    ~Group();
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;
    void commit();

   private:
    Ledger& ledger_;
  };

 private:
  struct State;
  class Write;
  [[nodiscard]] static Ledger open(const parameters::Study& study,
                                   std::span<const parameters::Realization> realizations,
                                   const RunOptions& options, std::unique_ptr<FileLock>& lock);
  /// Makes these what is pending with equal settings, failed ones if told to; returns how many.
  int take(const std::vector<StoredRun>& finished, bool failed_too);
  /// The same of what a damaged database holds; what is left goes to the unused runs.
  int save(const Salvage& salvaged, bool failed_too);
  explicit Ledger(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace cpt::results

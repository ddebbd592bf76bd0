// An edit of a study loses nothing that has finished: results wait, unused, until the study has their
// settings again.
#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "results/files/database.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/ledger/matching.hpp"
#include "results/ledger/schema.hpp"
#include "results/ledger/views.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class Unused : public ScratchFolder {
 protected:
  parameters::Study study = sand_study(folder);

  void run_all(const parameters::Study& asked, double limited_share = 0.0) {
    Ledger ledger = open(asked);
    for (const int id : ledger.pending()) {
      ledger.mark_running(id);
      solver::Outcome outcome =
          id == 4 ? failed(solver::Status::energy_drift, "error 0.2") : completed(1e6 * id);
      outcome.audit.limited_share = outcome.audit.safeguarded_share = limited_share;
      ledger.record(id, outcome);
    }
  }
  [[nodiscard]] std::int64_t count(const std::string& sql) const {
    return Database(study.database, Database::Mode::read_only).integer(sql);
  }
  void execute(const std::string& sql) const {
    Database(study.database, Database::Mode::read_write).execute(sql);
  }
  [[nodiscard]] std::string everything() const {
    return dump_without_times(study.database) +
           format(query_sql(study.database,
                            "SELECT id, started, finished, wall_s, reason FROM realization ORDER BY id"),
                  Format::json) +
           format(query_sql(study.database, "SELECT * FROM checksum ORDER BY realization"), Format::json);
  }
  static bool tells(const Ledger& ledger, const std::string& part) {
    for (const std::string& message : ledger.opened().messages)
      if (message.find(part) != std::string::npos) return true;
    return false;
  }
  static void fix_friction(parameters::Study& edited) { edited.baseline.contact.friction_ratio = 0.75; }
};

TEST_F(Unused, ThereAndBackRunsNothingAgain) {
  run_all(study);
  const std::string before = everything();
  parameters::Study edited = study;
  fix_friction(edited);  // all rows have other settings
  {
    const Ledger ledger = open(edited);
    EXPECT_EQ(ledger.opened().kept, 0);
    EXPECT_EQ(ledger.opened().set_aside, 8);
    EXPECT_EQ(ledger.opened().unused, 8);
    EXPECT_EQ(ledger.opened().fresh, 8);
    EXPECT_EQ(ledger.pending().size(), 8u);
    EXPECT_TRUE(tells(ledger, "8 realizations finished before that fit no row of the study"));
    EXPECT_TRUE(tells(ledger, "8 realizations new"));
    EXPECT_TRUE(tells(ledger, "the study has changed: contact.friction_ratio: 0.75, was 0.5"));
  }
  EXPECT_EQ(count("SELECT count(*) FROM curve"), 0);
  EXPECT_EQ(count("SELECT count(*) FROM window_mean"), 0);
  EXPECT_EQ(count("SELECT count(*) FROM unused_curve"), 7);
  EXPECT_EQ(count("SELECT count(*) FROM unused WHERE status = 'energy_drift'"), 1);
  {
    const Ledger ledger = open(study);
    EXPECT_EQ(ledger.opened().kept, 7);
    EXPECT_EQ(ledger.opened().failed, 1);
    EXPECT_EQ(ledger.opened().used_again, 8);
    EXPECT_EQ(ledger.opened().unused, 0);
    EXPECT_TRUE(ledger.pending().empty());
    EXPECT_TRUE(tells(ledger, "8 realizations among these unused until now"));
  }
  EXPECT_EQ(everything(), before);
  for (const char* table : {"unused", "unused_curve", "unused_checksum", "former_study"})
    EXPECT_EQ(count(fmt::format("SELECT count(*) FROM {}", table)), 0) << table;
}

TEST_F(Unused, BothSettingsOfAStudyAreKeptAndNeverMixed) {
  run_all(study);
  const std::string first = everything();
  parameters::Study edited = study;
  fix_friction(edited);
  {
    Ledger ledger = open(edited);
    for (const int id : ledger.pending()) ledger.record(id, completed(3e6 * id));
  }
  const std::string second = everything();
  EXPECT_NE(second, first);
  for (int k = 0; k < 2; ++k) {
    EXPECT_TRUE(open(study).pending().empty());
    EXPECT_EQ(everything(), first);
    EXPECT_TRUE(open(edited).pending().empty());
    EXPECT_EQ(everything(), second);
  }
  EXPECT_EQ(count("SELECT count(*) FROM former_study"), 1);
}

TEST_F(Unused, WhatTheyWereIsKept) {
  run_all(study);
  parameters::Study edited = study;
  edited.rows[0].upper = 80;
  { open(edited); }
  const Table table = query_sql(
      study.database,
      "SELECT u.parameter, side, value, value_text, status, f.name, f.study_text, f.baseline_setup = "
      "campaign.baseline_setup FROM unused AS u JOIN former_study AS f ON f.id = u.study, campaign");
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0],
            (std::vector<Cell>{std::string("sand.H"), std::string("upper"), 75.0, std::string("75"),
                               std::string("completed"), std::string("sand"), std::string("[study]\n"),
                               std::int64_t{1}}));
}

TEST_F(Unused, ReadersSeeOnlyWhatTheStudyAsksFor) {
  run_all(study);
  parameters::Study edited = study;
  edited.rows.erase(edited.rows.begin());
  { open(edited); }
  const Snapshot s = read_snapshot(study.database);
  EXPECT_EQ(s.realizations.size(), 6u);
  EXPECT_EQ(s.curves.size(), 5u);
  (void)sync_curves(edited.curves, edited.database);
  EXPECT_EQ(read_curves(edited.curves).size(), 5u);
}

TEST_F(Unused, ResultsOfAnotherSolverVersionStayAndAreNotCounted) {
  run_all(study);
  // As another version left them: the hash and the checksum have the version in them.
  execute("UPDATE realization SET solver_version = '0.1', settings_hash = 'old' || id; DELETE FROM checksum");
  {
    Ledger ledger = open(study);
    EXPECT_EQ(ledger.opened().kept, 0);
    EXPECT_EQ(ledger.opened().of_other_solvers, 8);
    EXPECT_EQ(ledger.pending().size(), 8u);
    EXPECT_TRUE(tells(ledger, "8 realizations made by solver version 0.1"));
    ledger.record(1, completed(1e6));
  }
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().kept, 1);
  EXPECT_EQ(ledger.opened().of_other_solvers, 8);
  EXPECT_EQ(count("SELECT count(*) FROM unused WHERE solver_version = '0.1'"), 8);
}

TEST_F(Unused, DamagedOnesRunAgain) {
  run_all(study);
  parameters::Study edited = study;
  fix_friction(edited);
  { open(edited); }
  execute("UPDATE unused SET energy_error = energy_error + 1e-9 WHERE value_text = '75'");
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().damaged, 1);
  EXPECT_EQ(ledger.opened().kept, 6);
  EXPECT_EQ(ledger.pending(), std::vector<int>{3});
}

TEST_F(Unused, FailedOnesAreRunAgainOnRequestOnly) {
  run_all(study);
  parameters::Study edited = study;
  fix_friction(edited);
  { open(edited); }
  const Ledger ledger = open(study, true);
  EXPECT_EQ(ledger.opened().retried, 1);
  EXPECT_EQ(ledger.pending(), std::vector<int>{4});
}

TEST_F(Unused, UnfinishedOnesLeaveNothing) {
  {
    Ledger ledger = open(study);
    ledger.record(1, completed(1e6));
    ledger.record(2, failed(solver::Status::rank_lost, "gone"));
    ledger.mark_running(3);
  }
  parameters::Study edited = study;
  fix_friction(edited);
  EXPECT_EQ(open(edited).opened().set_aside, 1);
  EXPECT_EQ(count("SELECT count(*) FROM unused"), 1);
}

TEST_F(Unused, AreTakenFromAnotherCampaignToo) {
  run_all(study);
  parameters::Study edited = study;
  fix_friction(edited);
  { open(edited); }
  execute("DROP VIEW tornado; DROP VIEW sensitivity");  // an earlier program's are of no use here
  parameters::Study other = study;
  other.name = "other";
  other.database = folder / "other.sqlite";
  Ledger ledger = open(other);
  EXPECT_EQ(ledger.adopt(study.database), 7);  // but the failed one
  EXPECT_EQ(ledger.pending(), std::vector<int>{4});
  EXPECT_EQ(read_run(other.database, 3)->profile->q_c, completed(3e6).profile.q_c);
  EXPECT_EQ(read_snapshot(other.database).window_means.size(), 14u);
}

TEST_F(Unused, AreSavedFromADamagedDatabase) {
  run_all(study);
  parameters::Study edited = study;
  fix_friction(edited);
  {
    Ledger ledger = open(edited);
    for (const int id : ledger.pending()) ledger.record(id, completed(3e6 * id));
  }
  // The structure is broken, the rows are whole.
  execute(
      "PRAGMA foreign_keys = OFF; PRAGMA writable_schema = ON; INSERT INTO window_mean (realization, "
      "window, from_m, to_m, q_c_mean_kPa) VALUES (99, 'deep', 0, 0, 1)");
  {
    const Ledger ledger = open(edited);
    EXPECT_EQ(ledger.opened().kept, 8);
    EXPECT_EQ(ledger.opened().unused, 8);
    EXPECT_TRUE(tells(ledger, "sand.sqlite.damaged"));
  }
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().kept, 7);
  EXPECT_EQ(ledger.opened().failed, 1);
  EXPECT_TRUE(ledger.pending().empty());
  EXPECT_EQ(read_run(study.database, 3)->profile->q_c, completed(3e6).profile.q_c);
}

TEST_F(Unused, RunsOfAnEarlierSchemaAreSavedFromADamagedDatabase) {
  run_all(study);
  execute(
      "DROP TABLE realization_input; ALTER TABLE curve DROP COLUMN wall_stress_Pa;"
      "ALTER TABLE unused_curve DROP COLUMN wall_stress_Pa; PRAGMA user_version = 5;"
      "PRAGMA foreign_keys = OFF; PRAGMA writable_schema = ON; INSERT INTO window_mean (realization, "
      "window, from_m, to_m, q_c_mean_kPa) VALUES (99, 'deep', 0, 0, 1)");
  const Ledger ledger = open(study);
  EXPECT_TRUE(tells(ledger, "sand.sqlite.damaged"));
  EXPECT_EQ(ledger.opened().kept, 7);
  EXPECT_EQ(read_run(study.database, 3)->profile->q_c, completed(3e6).profile.q_c);
}

TEST_F(Unused, AreToldBeforeAnythingIsWritten) {
  run_all(study);
  const std::string before = everything();
  parameters::Study edited = study;
  fix_friction(edited);
  int told = 0;
  const auto tell = [&](std::string_view) {
    EXPECT_EQ(everything(), before);
    ++told;
  };
  const Ledger ledger =
      Ledger::open_for_run(edited, parameters::all_realizations(edited), {"[study]\n", false, {}, tell});
  EXPECT_EQ(told, static_cast<int>(ledger.opened().messages.size()));
  EXPECT_GT(told, 2);
  EXPECT_NE(everything(), before);
}

TEST_F(Unused, ALookAtWhatAStudyAsksForWritesNothing) {
  run_all(study);
  const std::string before = everything();
  parameters::Study edited = study;
  edited.rows[0].upper = 80;
  const Database database(study.database, Database::Mode::read_only);
  const Matching matching = match(database, edited, parameters::all_realizations(edited));
  ASSERT_EQ(matching.realizations.size(), 8u);
  EXPECT_FALSE(matching.realizations[2].held.has_value());
  EXPECT_EQ(matching.realizations[3].held->status, "energy_drift");
  ASSERT_EQ(matching.left.size(), 1u);
  EXPECT_EQ(matching.left[0].id, 3);
  EXPECT_EQ(everything(), before);
}

std::vector<std::tuple<int, std::string, double, std::string>> inputs_of(const Snapshot& snapshot) {
  std::vector<std::tuple<int, std::string, double, std::string>> inputs;
  for (const InputRow& row : snapshot.inputs)
    inputs.emplace_back(row.realization, row.quantity, row.value, row.value_text);
  return inputs;
}

// Ledgers of all earlier schema versions; only the last of them had unused runs.
TEST_F(Unused, OlderLedgersAreUpgradedByTheEdit) {
  for (const int version : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
    std::filesystem::remove(study.database);
    run_all(study, NAN);  // not recorded then
    const std::string before = everything();
    const Snapshot now = read_snapshot(study.database);
    std::string older;
    for (const View& view : views()) older += fmt::format("DROP VIEW {};", view.name);
    older +=
        "ALTER TABLE curve DROP COLUMN outputs; ALTER TABLE unused_curve DROP COLUMN outputs;"
        "ALTER TABLE depth_window DROP COLUMN output; ALTER TABLE depth_window DROP COLUMN output_unit;"
        "DROP TABLE program_output;";
    if (version < 9) older += "DROP TABLE effect; DROP TABLE depth_band;";
    if (version < 8)
      older +=
          "ALTER TABLE realization DROP COLUMN safeguarded_share; ALTER TABLE unused DROP COLUMN "
          "safeguarded_share;";
    if (version < 7)
      older +=
          "ALTER TABLE realization DROP COLUMN limited_share; ALTER TABLE unused DROP COLUMN "
          "limited_share;";
    if (version < 6)
      older +=
          "DROP TABLE realization_input; ALTER TABLE curve DROP COLUMN wall_stress_Pa;"
          "ALTER TABLE unused_curve DROP COLUMN wall_stress_Pa; ALTER TABLE window_mean DROP COLUMN "
          "f_s_mean_kPa;"
          "ALTER TABLE window_mean DROP COLUMN wall_stress_mean_kPa;";
    if (version < 5)
      older +=
          "DROP TABLE unused_checksum; DROP TABLE unused_curve; DROP TABLE unused; DROP TABLE former_study;";
    if (version < 4) older += "DROP TABLE import;";
    if (version < 3) older += "DROP TABLE repeat_noise;";
    execute(older + "PRAGMA user_version = " + std::to_string(version));
    EXPECT_EQ(prospect(study)->opened.kept, 7);
    EXPECT_EQ(count("PRAGMA user_version"), version) << "a look upgrades nothing";
    const Snapshot looked = read_snapshot(study.database);
    EXPECT_EQ(looked.curves.size(), 7u) << version;
    EXPECT_EQ(inputs_of(looked), inputs_of(now)) << "read from texts, as they were stored then";

    parameters::Study edited = study;
    fix_friction(edited);
    EXPECT_EQ(open(edited).opened().set_aside, 8);
    EXPECT_EQ(count("PRAGMA user_version"), schema_version);
    EXPECT_TRUE(open(study).pending().empty());
    EXPECT_EQ(everything(), before) << version;
  }
}

TEST_F(Unused, WhatEndsBeforeTheCommitLeavesTheStudyAsItWas) {
  run_all(study);
  const std::string before = everything();
  parameters::Study edited = study;
  fix_friction(edited);
  struct Killed {};
  // What is told is the last step before the writes of the one transaction.
  EXPECT_THROW((void)Ledger::open_for_run(edited, parameters::all_realizations(edited),
                                          {"[study]\n", false, {}, [](std::string_view) { throw Killed{}; }}),
               Killed);
  EXPECT_EQ(everything(), before);
}

}  // namespace
}  // namespace cpt::results

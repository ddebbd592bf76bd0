// What a kill leaves behind, and what the next campaign on the same database does with it.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

#include "results/files/database.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/ledger/interrupted.hpp"
#include "results/ledger/ledger_watch.hpp"
#include "results/ledger/provenance.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"
#include "tests/solver/default_soils.hpp"

namespace cpt::results {
namespace {

class Resume : public ScratchFolder {
 protected:
  parameters::Study study = sand_study(folder);

  /// Runs `work` in a process of its own, which ends there without any destructor.
  template <class Work>
  static void in_killed_process(const Work& work) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      work();
      kill(getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
  }
  static std::string message_of(const auto& action) {
    try {
      action();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(Resume, KilledBetweenRecordsKeepsWhatEndedAndRequeuesWhatRan) {
  in_killed_process([&] {
    Ledger ledger = open(study);
    ledger.record(1, completed(1e6));
    ledger.record(2, failed(solver::Status::crashed, "signal 11"));
    ledger.mark_running(3);
  });
  const Ledger ledger = open(study);
  EXPECT_FALSE(ledger.opened().created);
  EXPECT_EQ(ledger.opened().kept, 1);
  EXPECT_EQ(ledger.opened().failed, 1);
  EXPECT_EQ(ledger.opened().interrupted, 1);
  EXPECT_EQ(ledger.pending(), (std::vector<int>{3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(ledger.opened().messages.size(), 3u);
}

TEST_F(Resume, WhatRanWhenTheCampaignEndedIsInterruptedForReaders) {
  const auto status = [&](int id) {
    return std::string(
        status_words(read_snapshot(study.database).realizations[static_cast<std::size_t>(id) - 1]));
  };
  const auto asked = [&] { return format(query(study.database, "realizations"), Format::csv); };
  {
    Ledger ledger = open(study);
    ledger.record(1, completed(1e6));
    ledger.mark_running(3);
    EXPECT_EQ(status(3), "running") << "the lock is held";
    EXPECT_NE(asked().find(",running,"), std::string::npos);
  }
  in_killed_process([&] {
    Ledger ledger = open(study);
    ledger.mark_running(3);
  });
  EXPECT_EQ(status(1), "completed");
  EXPECT_EQ(status(3), "interrupted");
  EXPECT_EQ(status(4), "pending");
  EXPECT_EQ(asked().find(",running,"), std::string::npos) << asked();
  EXPECT_NE(asked().find(",interrupted,"), std::string::npos) << asked();
  const Snapshot s = read_snapshot(study.database);
  EXPECT_TRUE(s.realizations[2].waiting());
  EXPECT_FALSE(s.realizations[2].failed());
  for (const SensitivityRow& row : s.sensitivity) EXPECT_EQ(row.note.find("running"), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(
      s.sensitivity, [](const auto& row) { return row.note.find("interrupted") != std::string::npos; }));
  LedgerWatch watch(study.database);
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
  EXPECT_EQ(open(study).opened().interrupted, 1) << "the next start takes it up";
}

TEST_F(Resume, AWatchNoticesThatACampaignWasKilled) {
  { const Ledger made = open(study); }
  int ready[2], end[2];
  ASSERT_EQ(pipe(ready), 0);
  ASSERT_EQ(pipe(end), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Ledger ledger = open(study);
    ledger.mark_running(1);
    (void)!write(ready[1], "x", 1);
    char byte = 0;
    (void)!read(end[0], &byte, 1);
    raise(SIGKILL);
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  LedgerWatch watch(study.database);
  EXPECT_TRUE(watch.changed());
  EXPECT_FALSE(watch.changed());
  EXPECT_EQ(read_snapshot(study.database).realizations[0].status, "running");
  ASSERT_EQ(write(end[1], "x", 1), 1);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(watch.changed()) << "nothing was committed, but nobody runs it";
  EXPECT_TRUE(interrupted(read_snapshot(study.database).realizations[0]));
  for (const int descriptor : {ready[0], ready[1], end[0], end[1]}) close(descriptor);
}

TEST_F(Resume, KilledInsideATransactionLeavesNoTraceOfIt) {
  { open(study).record(1, completed(1e6)); }
  const std::string before = dump_without_times(study.database);
  in_killed_process([&] {
    const Database database(study.database, Database::Mode::read_write);
    Transaction transaction(database, Transaction::Kind::write);
    database.execute("UPDATE realization SET status = 'crashed'; DELETE FROM curve");
  });
  EXPECT_EQ(dump_without_times(study.database), before);
}

TEST_F(Resume, ResumedCampaignEqualsAnUndisturbedOne) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 + 1e5 * id));
  }
  const std::string undisturbed = dump_without_times(study.database);
  std::filesystem::remove(study.database);
  for (int k = 0; k < 8; ++k)
    in_killed_process([&] {
      Ledger ledger = open(study);
      const int id = ledger.pending().back();
      ledger.mark_running(ledger.pending().front());
      ledger.record(id, completed(1e6 + 1e5 * id));
    });
  EXPECT_EQ(dump_without_times(study.database), undisturbed);
}

TEST_F(Resume, ReadableAfterAKillWithoutAnyWriter) {
  in_killed_process([&] { open(study).record(1, completed(1e6)); });
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 1u);
}

TEST_F(Resume, SecondCampaignOnTheSameDatabaseIsRefused) {
  const Ledger first = open(study);
  const std::string message = message_of([&] { open(study); });
  EXPECT_NE(message.find("held by process " + std::to_string(getpid())), std::string::npos) << message;
  EXPECT_THROW(open(study), Locked);
}

TEST_F(Resume, LockEndsWithItsProcess) {
  in_killed_process([&] { (void)new Ledger(open(study)); });
  EXPECT_TRUE(std::filesystem::exists(study.database.string() + ".lock"));
  EXPECT_NO_THROW(open(study));
}

TEST_F(Resume, LostRankRunsAgainByItselfOtherFailuresOnDemand) {
  {
    Ledger ledger = open(study);
    ledger.record(1, failed(solver::Status::rank_lost, "worker 2 is gone"));
    ledger.record(2, failed(solver::Status::time_limit, "over 600 s"));
  }
  {
    const Ledger ledger = open(study);
    EXPECT_EQ(ledger.pending(), (std::vector<int>{1, 3, 4, 5, 6, 7, 8}));
  }
  const Ledger ledger = open(study, true);
  EXPECT_EQ(ledger.opened().retried, 1);
  EXPECT_EQ(ledger.pending().size(), 8u);
  EXPECT_EQ(read_run(study.database, 2)->row.reason, "");
}

TEST_F(Resume, ChangedBoundRunsAgainOthersAreKept) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  study.rows[0].upper = 80;
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().kept, 7);
  EXPECT_EQ(ledger.opened().set_aside, 1);
  EXPECT_EQ(ledger.pending(), std::vector<int>{3});
}

TEST_F(Resume, WhatWasEditedIsTold) {
  { open(study).record(1, completed(1e6)); }
  EXPECT_EQ(open(study).opened().messages.size(), 1u) << "only what is kept";
  study.rows[0].upper = 80;
  study.rows.pop_back();
  study.baseline.contact.friction_ratio = 0.75;
  study.windows[0].to = 0.33;
  const Ledger ledger = open(study);
  std::vector<std::string> told;
  for (const std::string& message : ledger.opened().messages)
    if (message.starts_with("the study has changed: ")) told.push_back(message.substr(23));
  EXPECT_EQ(told, (std::vector<std::string>{"contact.friction_ratio: 0.75, was 0.5",
                                            "initial.sigma_h0_kPa, bounds: gone, was 15 to 35",
                                            "sand.H, bounds: 20 to 80, was 20 to 75",
                                            "window deep: fixed 0.3 to 0.33 m, was fixed 0.3 to 0.32 m"}));
}

TEST_F(Resume, WhatIsDamagedRunsAgain) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  {
    const Database database(study.database, Database::Mode::read_write);
    database.execute(
        "UPDATE curve SET q_c_Pa = substr(q_c_Pa, 1, 800) || x'01' || substr(q_c_Pa, 802) WHERE realization "
        "= 3;"
        "UPDATE realization SET energy_error = energy_error + 1e-9 WHERE id = 4;"
        "UPDATE realization SET settings_hash = 'x' || settings_hash WHERE id = 5;"
        "UPDATE curve SET f_s_Pa = x'00' WHERE realization = 6");
  }
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().damaged, 4);
  EXPECT_EQ(ledger.opened().kept, 4);
  EXPECT_EQ(ledger.opened().unused, 0);
  EXPECT_EQ(ledger.pending(), (std::vector<int>{3, 4, 5, 6}));
  EXPECT_NE(ledger.opened().messages[1].find("4 realizations damaged"), std::string::npos);
}

TEST_F(Resume, DamagedDatabaseIsKeptAsideAndWhatIsWholeIsSaved) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  const std::string undisturbed = dump_without_times(study.database);
  // Its last pages: where the curves lie that were stored last.
  std::filesystem::resize_file(study.database, std::filesystem::file_size(study.database) - 8 * 4096);
  {
    Ledger ledger = open(study);
    const int kept = ledger.opened().kept;
    EXPECT_GT(kept, 0);
    EXPECT_LT(kept, 8);
    EXPECT_EQ(ledger.opened().pending, 8 - kept);
    EXPECT_EQ(ledger.pending().size(), static_cast<std::size_t>(8 - kept));
    EXPECT_NE(ledger.opened().messages.back().find("sand.sqlite.damaged"), std::string::npos);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  EXPECT_EQ(dump_without_times(study.database), undisturbed);
  EXPECT_TRUE(std::filesystem::exists(study.database.string() + ".damaged"));
}

TEST_F(Resume, ChangedViewsAreMadeAnew) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  const auto definition = [&] {
    const Database database(study.database, Database::Mode::read_only);
    Statement view = database.prepare("SELECT sql FROM sqlite_schema WHERE name = 'sensitivity'");
    return view.step() ? view.text(0) : "";
  };
  const std::string before = dump_without_times(study.database), view_before = definition();
  {
    const Database database(study.database, Database::Mode::read_write);
    const auto version = [&] { return database.integer("PRAGMA schema_version"); };
    const auto untouched = version();
    { open(study); }
    EXPECT_EQ(version(), untouched) << "views that are as they should be are left alone";
    database.execute(
        "PRAGMA writable_schema = ON;"
        "UPDATE sqlite_schema SET sql = replace(sql, 'u.q_c_mean_kPa > 0', 'u.q_c_mean_kPa < 0') "
        "WHERE name = 'sensitivity'; PRAGMA writable_schema = RESET");
  }
  EXPECT_NE(definition(), view_before);
  EXPECT_EQ(dump_without_times(study.database), before) << "who reads has views of his own";
  { open(study); }
  EXPECT_EQ(definition(), view_before);
  EXPECT_EQ(dump_without_times(study.database), before);
}

TEST_F(Resume, RunsOfProgramsWithoutChecksumsAreKept) {
  { open(study).record(1, completed(1e6)); }
  Database(study.database, Database::Mode::read_write)
      .execute("DROP TABLE checksum; PRAGMA user_version = 2");
  EXPECT_EQ(open(study).opened().kept, 1);
}

TEST_F(Resume, JournalSuitsTheFileSystem) {
  const auto journal = [&](FileSystem system) {
    RunOptions options;
    options.file_system = system;
    const Ledger ledger = Ledger::open_for_run(study, parameters::all_realizations(study), options);
    const Database database(study.database, Database::Mode::read_only);
    Statement mode = database.prepare("PRAGMA journal_mode");
    EXPECT_TRUE(mode.step());
    return mode.text(0);
  };
  EXPECT_EQ(journal(FileSystem::local), "wal");
  EXPECT_EQ(journal(FileSystem::network), "delete");
  // Left in WAL mode by a kill on another file system.
  in_killed_process([&] { open(study).record(1, completed(1e6)); });
  EXPECT_EQ(journal(FileSystem::network), "delete");
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 1u);
}

TEST(FileSystems, AreKnownByTheirMagicNumbers) {
  for (const std::uint64_t network : {0x6969u, 0x517bu, 0xff534d42u, 0xfe534d42u, 0x0bd00bd0u, 0x47504653u,
                                      0x19830326u, 0x00c36400u, 0x65735546u})
    EXPECT_EQ(file_system_of_magic(network), FileSystem::network) << std::hex << network;
  // ext4, XFS, btrfs, tmpfs, overlayfs, ZFS
  for (const std::uint64_t local : {0xef53u, 0x58465342u, 0x9123683eu, 0x01021994u, 0x794c7630u, 0x2fc12fc1u})
    EXPECT_EQ(file_system_of_magic(local), FileSystem::local) << std::hex << local;
  EXPECT_EQ(file_system_of("/nowhere/at/all/x.sqlite"), FileSystem::network);
}

TEST_F(Resume, ReorderedAndRemovedRowsKeepTheirRuns) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  study.rows.erase(study.rows.begin() + 1);
  std::swap(study.rows.front(), study.rows.back());
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().kept, 7);
  EXPECT_EQ(ledger.opened().set_aside, 1);
  EXPECT_TRUE(ledger.pending().empty());
  const StoredRun moved = read_run(study.database, 2).value();  // now sigma_h0's lower bound, before id 7
  EXPECT_EQ(moved.row.parameter, "initial.sigma_h0_kPa");
  EXPECT_EQ(moved.row.side, "lower");
  EXPECT_EQ(moved.profile->q_c, completed(7e6).profile.q_c);
}

TEST_F(Resume, MovedWindowIsAveragedAnewFromStoredCurves) {
  {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  study.windows = {{"shallow", parameters::Window::Kind::fixed, 0.05, 0.06, 0.0}};
  const Ledger ledger = open(study);
  EXPECT_TRUE(ledger.pending().empty());
  const Snapshot s = read_snapshot(study.database);
  ASSERT_EQ(s.window_means.size(), 8u);
  EXPECT_EQ(s.window_means[0].window, "shallow");
  EXPECT_NEAR(s.window_means[0].q_c_mean_kPa, 1e3 * std::sqrt(0.055), 15.0);
}

TEST_F(Resume, AnotherStudysResultsAreNotDestroyed) {
  { open(study).record(1, completed(1e6)); }
  study.name = "clay";
  solver::sand_of(study.baseline).H = 30;
  const std::string before = dump_without_times(study.database);
  const std::string message = message_of([&] { open(study); });
  EXPECT_NE(message.find("'sand'"), std::string::npos) << message;
  EXPECT_EQ(dump_without_times(study.database), before);
}

TEST_F(Resume, RenamedStudyKeepsItsRuns) {
  { open(study).record(1, completed(1e6)); }
  study.name = "sand2";
  EXPECT_EQ(open(study).opened().kept, 1);
}

TEST_F(Resume, FilesThatAreNoLedgerAreNamedAndLeftAlone) {
  std::ofstream(study.database) << "this is a text, long enough to hold a header of some hundred bytes. "
                                << std::string(200, 'x');
  EXPECT_NE(message_of([&] { open(study); }).find("not an SQLite database"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)read_snapshot(study.database); }).find("not an SQLite database"),
            std::string::npos);
  std::filesystem::remove(study.database);
  Database(study.database, Database::Mode::read_write).execute("CREATE TABLE notes (text)");
  EXPECT_NE(message_of([&] { open(study); }).find("not one of a campaign"), std::string::npos);
  EXPECT_EQ(Database(study.database, Database::Mode::read_only).integer("SELECT count(*) FROM sqlite_schema"),
            1);
}

TEST_F(Resume, OtherSchemaVersionIsRefused) {
  { open(study); }
  Database(study.database, Database::Mode::read_write).execute("PRAGMA user_version = 77");
  EXPECT_NE(message_of([&] { open(study); }).find("schema version 77"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)read_snapshot(study.database); }).find("schema version 77"),
            std::string::npos);
}

// A ledger of schema version 1: neither repeats nor checksums, and no side but the bounds'.
TEST_F(Resume, AnOlderLedgerIsReadAndGoesOn) {
  {
    Ledger ledger = open(study);
    for (int id = 1; id <= 3; ++id) ledger.record(id, completed(1e6 * id));
  }
  Database(study.database, Database::Mode::read_write)
      .execute(
          "DROP VIEW tornado; DROP VIEW sensitivity; DROP TABLE repeat_noise; DROP TABLE checksum;"
          "CREATE VIEW sensitivity AS SELECT w.name AS window, p.name AS parameter, NULL AS q_lower_kPa, "
          "NULL AS q_upper_kPa, NULL AS q_baseline_kPa, NULL AS si, NULL AS si_abs, NULL AS si_noise, "
          "NULL AS above_noise, '' AS note FROM depth_window AS w, parameter AS p;"
          "CREATE VIEW tornado AS SELECT * FROM sensitivity;"
          "PRAGMA writable_schema = ON;"
          "UPDATE sqlite_schema SET sql = replace(sql, ', ''point'', ''repeat''', '') WHERE name = "
          "'realization';"
          "PRAGMA writable_schema = OFF; PRAGMA user_version = 1");
  const Snapshot old = read_snapshot(study.database);
  EXPECT_EQ(old.window_means.size(), 6U);
  EXPECT_TRUE(old.repeat_noise.empty());

  study.points.push_back({"repeat 1", {{solver::find_quantity("numerics.point_shift"), 0.4}}, true});
  study.points.push_back({"repeat 2", {{solver::find_quantity("numerics.point_shift"), -0.4}}, true});
  Ledger ledger = open(study);
  EXPECT_EQ(ledger.opened().kept, 3);
  EXPECT_EQ(ledger.opened().pending, 7);
  ledger.record(9, completed(1.1e6));
  ledger.record(10, completed(0.9e6));
  const Snapshot upgraded = read_snapshot(study.database);
  EXPECT_EQ(upgraded.repeat_noise.size(), 2U);
  for (int id = 1; id <= 3; ++id)
    EXPECT_FALSE(first_difference(read_run(study.database, id)->profile.value(), completed(1e6 * id).profile)
                     .has_value());
  const Database database(study.database, Database::Mode::read_only);
  EXPECT_EQ(database.integer("SELECT count(*) FROM sqlite_schema WHERE name LIKE 'old%'"), 0);
  EXPECT_FALSE(database.prepare("PRAGMA foreign_key_check").step());
}

// What was half written lies in a journal that a reader may not play back; it is played back for the reader.
TEST_F(Resume, AReaderFollowsAWriterKilledAmidAWrite) {
  {
    Ledger ledger = open(study);
    for (int id = 1; id <= 8; ++id) ledger.record(id, completed(1e6 * id));
  }
  const std::string before = dump_without_times(study.database);
  in_killed_process([&] {
    const Database database(study.database, Database::Mode::read_write);
    database.execute(
        "PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; BEGIN IMMEDIATE; UPDATE curve SET depth_m = "
        "zeroblob(6400)");
    kill(getpid(), SIGKILL);  // before the connection is closed
  });
  ASSERT_TRUE(std::filesystem::exists(study.database.string() + "-journal"));
  EXPECT_EQ(dump_without_times(study.database), before);
}

}  // namespace
}  // namespace cpt::results

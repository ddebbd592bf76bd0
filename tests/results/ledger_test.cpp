#include "results/ledger/ledger.hpp"

#include <algorithm>
#include <random>

#include "results/ledger/provenance.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {

std::string dump_without_times(const std::filesystem::path& database) {
  std::string dump;
  for (const char* sql :
       {"SELECT name, title, profile, preset, study_text, baseline_setup, program_version, solver_version "
        "FROM campaign",
        "SELECT * FROM layer", "SELECT * FROM parameter", "SELECT * FROM depth_window",
        "SELECT * FROM window_mean",
        "SELECT id, parameter, side, value, status, reason, steps, material_points, settings_hash, "
        "solver_version, "
        "mass_error, momentum_error, energy_error, max_empty_cells FROM realization ORDER BY id",
        "SELECT realization, bins, hex(depth_m), hex(q_c_Pa), hex(f_s_Pa) FROM curve ORDER BY realization",
        "SELECT * FROM sensitivity", "SELECT * FROM tornado"})
    dump += format(query_sql(database, sql), Format::json);
  return dump;
}

namespace {

class LedgerTest : public ScratchFolder {
 protected:
  parameters::Study study = sand_study(folder);
};

TEST_F(LedgerTest, NewDatabaseHoldsEveryRealizationPending) {
  const Ledger ledger = open(study);
  EXPECT_TRUE(ledger.opened().created);
  EXPECT_EQ(ledger.opened().pending, 8);
  EXPECT_EQ(ledger.pending(), (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
  const Snapshot s = read_snapshot(study.database);
  EXPECT_EQ(s.campaign.name, "sand");
  EXPECT_EQ(s.campaign.study_text, "[study]\n");
  EXPECT_EQ(s.campaign.solver_version, solver::solver_version());
  EXPECT_EQ(s.campaign.baseline_setup, solver::canonical_text(study.baseline));
  ASSERT_EQ(s.parameters.size(), 5u);
  EXPECT_EQ(s.parameters[3].lower_text, "flexible");
  EXPECT_EQ(s.parameters[3].upper_text, "rigid");
  EXPECT_EQ(s.parameters[4].unit, "kPa");
  EXPECT_EQ(s.parameters[4].upper, 35.0);
  ASSERT_EQ(s.layers.size(), 1u);
  EXPECT_EQ(s.layers[0].soil, "sand");
  EXPECT_EQ(s.realizations[0].parameter, "");
  EXPECT_TRUE(std::isnan(s.realizations[0].value));
  EXPECT_EQ(s.realizations[2].value_text, "75");
  EXPECT_EQ(s.realizations[2].settings_hash,
            settings_hash(parameters::make_setup(study, parameters::all_realizations(study)[2])));
}

TEST_F(LedgerTest, RecordsEverythingOfAnOutcomeBitForBit) {
  Ledger ledger = open(study);
  const solver::Outcome outcome = completed(4.0e6);
  ledger.mark_running(1);
  ledger.record(1, outcome);
  const StoredRun run = read_run(study.database, 1).value();
  EXPECT_EQ(run.row.status, "completed");
  EXPECT_EQ(run.row.steps, outcome.steps);
  EXPECT_EQ(run.row.material_points, outcome.material_points);
  EXPECT_EQ(run.row.wall_s, outcome.wall_seconds);
  EXPECT_EQ(run.row.audit.momentum_error, outcome.audit.momentum_error);
  EXPECT_EQ(run.row.audit.max_time_step, outcome.audit.max_time_step);
  EXPECT_LE(run.row.started, run.row.finished);
  EXPECT_FALSE(first_difference(run.profile.value(), outcome.profile).has_value());
  EXPECT_FALSE(read_run(study.database, 99).has_value());
}

TEST_F(LedgerTest, KeepsTheCurveOfAFailureAsFarAsItCameButAveragesNothing) {
  Ledger ledger = open(study);
  solver::Outcome outcome = completed(4.0e6);
  outcome.status = solver::Status::energy_drift;
  outcome.reason = "energy error 0.2 exceeds 0.1";
  outcome.profile.q_c.back() = std::numeric_limits<double>::quiet_NaN();
  ledger.record(3, outcome);
  const StoredRun run = read_run(study.database, 3).value();
  EXPECT_EQ(run.row.reason, outcome.reason);
  EXPECT_TRUE(run.row.failed());
  EXPECT_FALSE(first_difference(run.profile.value(), outcome.profile).has_value());
  EXPECT_TRUE(read_snapshot(study.database).window_means.empty());
}

TEST_F(LedgerTest, CountsByState) {
  Ledger ledger = open(study);
  ledger.record(1, completed(1e6));
  ledger.record(2, failed(solver::Status::crashed, "signal 11"));
  ledger.mark_running(3);
  EXPECT_EQ(ledger.counts().completed, 1);
  EXPECT_EQ(ledger.counts().failed, 1);
  EXPECT_EQ(ledger.counts().running, 1);
  EXPECT_EQ(ledger.counts().pending, 5);
  EXPECT_EQ(ledger.counts().total(), 8);
  ledger.mark_pending(3);
  EXPECT_EQ(ledger.counts().pending, 6);
}

TEST_F(LedgerTest, NothingEndsTwice) {
  Ledger ledger = open(study);
  ledger.record(1, completed(1e6));
  EXPECT_THROW(ledger.record(1, completed(2e6)), std::logic_error);
  EXPECT_THROW(ledger.mark_running(1), std::logic_error);
  EXPECT_THROW(ledger.record(99, completed(2e6)), std::logic_error);
  EXPECT_EQ(read_run(study.database, 1)->profile->q_c, completed(1e6).profile.q_c);
}

TEST_F(LedgerTest, OrderOfCompletionDoesNotShow) {
  std::vector<int> ids = {1, 2, 3, 4, 5, 6, 7, 8};
  std::vector<std::string> dumps;
  std::mt19937 random(7);
  for (int k = 0; k < 3; ++k) {
    std::filesystem::remove(study.database);
    {
      Ledger ledger = open(study);
      for (const int id : ids) ledger.record(id, completed(1e6 * id));
    }
    dumps.push_back(dump_without_times(study.database));
    std::shuffle(ids.begin(), ids.end(), random);
  }
  EXPECT_EQ(dumps[0], dumps[1]);
  EXPECT_EQ(dumps[0], dumps[2]);
}

TEST_F(LedgerTest, HostileNamesAreOnlyText) {
  const std::string hostile = "x'); DROP TABLE realization; --\"<script>alert(1)</script>";
  study.title = hostile;
  study.windows[0].name = hostile;
  Ledger ledger = open(study);
  ledger.record(1, completed(4e6));
  ledger.record(2, failed(solver::Status::crashed, hostile));
  const Snapshot s = read_snapshot(study.database);
  EXPECT_EQ(s.campaign.title, hostile);
  EXPECT_EQ(s.windows[0].name, hostile);
  EXPECT_EQ(s.realizations[1].reason, hostile);
  EXPECT_EQ(s.window_means[0].window, hostile);
  EXPECT_EQ(s.realizations.size(), 8u);
}

TEST_F(LedgerTest, OpensWhileTheCampaignRunsAndSeesEachRecord) {
  Ledger ledger = open(study);
  ledger.record(1, completed(4e6));
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 1u);
  ledger.record(2, completed(3e6));
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 2u);
}

TEST_F(LedgerTest, AGroupIsThereAsAWholeAtItsCommit) {
  Ledger ledger = open(study);
  Ledger::Group group(ledger);
  group.commit();  // nothing yet
  ledger.mark_running(1);
  ledger.record(1, completed(4e6));
  ledger.mark_running(2);
  ledger.record(2, completed(3e6));
  EXPECT_EQ(ledger.counts().completed, 2);
  EXPECT_TRUE(read_snapshot(study.database).curves.empty()) << "others see it before the commit";
  group.commit();
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 2u);
  ledger.record(3, completed(2e6));
  group.commit();
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 3u);
}

TEST_F(LedgerTest, AGroupWithoutCommitLeavesNoTrace) {
  Ledger ledger = open(study);
  const std::string before = dump_without_times(study.database);
  {
    const Ledger::Group group(ledger);
    ledger.mark_running(1);
    ledger.record(1, completed(4e6));
  }
  EXPECT_EQ(dump_without_times(study.database), before);
  ledger.record(1, completed(4e6));
  EXPECT_EQ(read_snapshot(study.database).curves.size(), 1u) << "a record is a transaction of its own again";
}

TEST_F(LedgerTest, GroupedAndSingleRecordsMakeTheSameDatabase) {
  {
    Ledger ledger = open(study);
    for (int id = 1; id <= 8; ++id) ledger.record(id, completed(1e6 * id));
  }
  const std::string single = dump_without_times(study.database);
  std::filesystem::remove(study.database);
  {
    Ledger ledger = open(study);
    Ledger::Group group(ledger);
    for (int id = 8; id >= 1; --id) ledger.record(id, completed(1e6 * id));
    group.commit();
  }
  EXPECT_EQ(dump_without_times(study.database), single);
}

TEST_F(LedgerTest, EndedCampaignIsOnePlainFile) {
  { open(study).record(1, completed(4e6)); }
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path().filename());
  EXPECT_EQ(files, std::vector<std::string>{"sand.sqlite"});
}

TEST_F(LedgerTest, MissingFolderIsNamed) {
  study.database = folder / "nowhere" / "x.sqlite";
  try {
    open(study);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere"), std::string::npos);
  }
}

}  // namespace
}  // namespace cpt::results

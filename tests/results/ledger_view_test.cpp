// What readers see of a study whose file has been edited since its campaign last ran.
#include "results/ledger/ledger_view.hpp"

#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class View : public ScratchFolder {
 protected:
  void SetUp() override {
    Ledger ledger = open(study);
    for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
  }
  parameters::Study study = sand_study(folder);
};

TEST_F(View, OfAnUnchangedFileIsTheLedger) {
  const LedgerView view = view_ledger(study, "[study]\n");
  EXPECT_TRUE(view.notes.empty());
  EXPECT_EQ(read_snapshot(view).window_means.size(), 16u);
}

TEST_F(View, OfEditedWindowsIsWhatACampaignWouldStore) {
  study.windows = {{"shallow", parameters::Window::Kind::fixed, 0.05, 0.06, 0.0},
                   {"peak", parameters::Window::Kind::peak, 0.12, 0.18, 0.012}};
  const std::string before = dump_without_times(study.database);
  const LedgerView view = view_ledger(study, "edited\n");
  ASSERT_EQ(view.notes.size(), 1u);
  EXPECT_NE(view.notes[0].find("sand.toml has been edited"), std::string::npos);
  EXPECT_NE(view.notes[0].find("window deep: gone"), std::string::npos) << view.notes[0];
  const auto seen = [&](const Database& database) {
    std::string text;
    for (const char* what : {"windows", "sensitivity", "tornado", "realizations"})
      text += format(query(database, what), Format::csv);
    return text;
  };
  const std::string viewed = seen(view.database);
  EXPECT_EQ(dump_without_times(study.database), before) << "nothing is written";
  { open(study); }
  EXPECT_EQ(seen(Database(study.database, Database::Mode::read_only)), viewed);
}

TEST_F(View, TellsWhatIsNotRunAndWhatIsLeftOut) {
  study.rows[0].upper = 80;
  const LedgerView view = view_ledger(study, "edited\n");
  ASSERT_EQ(view.notes.size(), 3u);
  EXPECT_NE(view.notes[1].find("of its 8 realizations, 1 has not been run yet"), std::string::npos);
  EXPECT_NE(view.notes[2].find("1 stored result it no longer asks for"), std::string::npos);
  const Snapshot s = read_snapshot(view);
  EXPECT_EQ(s.realizations[2].status, "pending");
  EXPECT_EQ(s.realizations[2].value, 80.0);
  EXPECT_EQ(s.curves.size(), 7u);
  EXPECT_EQ(query(view.database, "unused").rows.size(), 1u);
}

TEST_F(View, TakesUnusedResultsThatFitAgain) {
  parameters::Study edited = study;
  edited.rows[0].upper = 80;
  {
    Ledger ledger = Ledger::open_for_run(edited, parameters::all_realizations(edited), {"edited\n", false});
    ledger.record(3, completed(9e6));
  }
  const Snapshot s = read_snapshot(view_ledger(study, "[study]\n"));
  EXPECT_EQ(s.curves.size(), 8u);
  EXPECT_EQ(s.curves[2].profile.q_c, completed(3e6).profile.q_c);
}

TEST_F(View, LeavesWhatRunsRunning) {
  study.rows[0].upper = 80;
  Ledger ledger = open(study);
  ledger.mark_running(3);
  parameters::Study edited = study;
  edited.windows[0].to = 0.33;
  const Snapshot s = read_snapshot(view_ledger(edited, "edited\n"));
  EXPECT_EQ(s.realizations[2].status, "running");
}

TEST_F(View, OfWordsAloneSaysNothing) { EXPECT_TRUE(view_ledger(study, "# a remark\n").notes.empty()); }

TEST_F(View, OfAnotherSolverVersionsResultsIsWhatIsStored) {
  Database(study.database, Database::Mode::read_write).execute("UPDATE campaign SET solver_version = '0.1'");
  study.windows.pop_back();
  const LedgerView view = view_ledger(study, "edited\n");
  ASSERT_EQ(view.notes.size(), 1u);
  EXPECT_NE(view.notes[0].find("solver version 0.1"), std::string::npos);
  EXPECT_EQ(read_snapshot(view).window_means.size(), 16u);
}

TEST_F(View, CanBeAskedButNotWritten) {
  study.windows.pop_back();
  const LedgerView view = view_ledger(study, "edited\n");
  EXPECT_EQ(query_sql(view.database, "SELECT count(*) FROM depth_window").rows[0][0], Cell(std::int64_t{1}));
  EXPECT_THROW((void)query_sql(view.database, "DELETE FROM curve"), Error);
}

}  // namespace
}  // namespace cpt::results

// Removing unused results: those that are named, and nothing else.
#include "results/ledger/pruning.hpp"

#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class Prune : public ScratchFolder {
 protected:
  void SetUp() override {
    {
      Ledger ledger = open(study);
      for (const int id : ledger.pending()) ledger.record(id, completed(1e6 * id));
    }
    edited.baseline.contact.friction_ratio = 0.75;
    Ledger ledger = open(edited);
    for (const int id : ledger.pending()) ledger.record(id, completed(2e6 * id));
  }
  parameters::Study study = sand_study(folder), edited = study;
};

TEST_F(Prune, NamesWhatIsUnusedAndWhatItsStudyHadOtherwise) {
  const Database database(study.database, Database::Mode::read_only);
  const auto runs = unused_runs(database);
  ASSERT_EQ(runs.size(), 8u);
  EXPECT_EQ(runs[0].side, "baseline");
  EXPECT_EQ(runs[2].parameter, "sand.H");
  EXPECT_EQ(runs[2].value_text, "75");
  EXPECT_EQ(former_settings(database, runs[2].study),
            std::vector<std::string>{"contact.friction_ratio = 0.5 (now 0.75)"});
}

TEST_F(Prune, RemovesWhatItIsToldAndNothingElse) {
  const std::string before = dump_without_times(study.database);
  {
    Pruning pruning(study.database);
    auto runs = unused_runs(pruning.database());
    runs.resize(3);
    pruning.remove(runs);
    EXPECT_EQ(unused_runs(pruning.database()).size(), 5u);
    EXPECT_EQ(pruning.database().integer("SELECT count(*) FROM unused_curve"), 5);
    EXPECT_EQ(pruning.database().integer("SELECT count(*) FROM unused_checksum"), 5);
    EXPECT_EQ(pruning.database().integer("SELECT count(*) FROM former_study"), 1);
  }
  EXPECT_EQ(dump_without_times(study.database), before);
  const Ledger ledger = open(study);
  EXPECT_EQ(ledger.pending(), (std::vector<int>{1, 2, 3}));
}

TEST_F(Prune, GivesRoomBack) {
  Pruning pruning(study.database);
  pruning.remove(unused_runs(pruning.database()));
  EXPECT_GT(pruning.shrink(), 100'000);
  EXPECT_EQ(pruning.database().integer("SELECT count(*) FROM former_study"), 0);
  EXPECT_TRUE(unused_runs(pruning.database()).empty());
}

TEST_F(Prune, ACampaignAndAPruningExcludeEachOther) {
  {
    const Ledger ledger = open(edited);
    EXPECT_THROW(Pruning pruning(study.database), Locked);
  }
  const Pruning pruning(study.database);
  EXPECT_THROW(open(edited), Locked);
}

TEST_F(Prune, OfNoLedgerLeavesNothingBehind) {
  EXPECT_THROW(Pruning pruning(folder / "none.sqlite"), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.sqlite.lock"));
}

}  // namespace
}  // namespace cpt::results

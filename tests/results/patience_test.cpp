// A database that another program keeps locked: waited for, or left with its name.
#include "results/files/patience.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include "results/files/database.hpp"
#include "results/tables/query.hpp"
#include "tests/results/campaign_fixture.hpp"

namespace cpt::results {
namespace {

class PatienceTest : public ScratchFolder {
 protected:
  PatienceTest() : study(sand_study(folder)) { open(study); }
  [[nodiscard]] Database other() const { return {study.database, Database::Mode::read_write}; }
  parameters::Study study;
};

TEST_F(PatienceTest, WaitsUntilTheOtherIsDone) {
  const Database browser = other();
  browser.execute("BEGIN EXCLUSIVE");
  int asked = 0;
  const Patience patience([&](const std::filesystem::path& database, double seconds) {
    EXPECT_EQ(database.filename(), "sand.sqlite");
    EXPECT_DOUBLE_EQ(seconds, 0.05 * asked);
    if (++asked == 3) browser.execute("COMMIT");
    return true;
  });
  EXPECT_EQ(query(study.database, "realizations").rows.size(), 8U);
  EXPECT_EQ(asked, 3);
}

TEST_F(PatienceTest, GivesUpWithTheCauseAndWhatToDo) {
  const Database browser = other();
  browser.execute("BEGIN EXCLUSIVE");
  const Patience none([](const auto&, double) { return false; });
  const auto busy = [&](const auto& call) {
    try {
      call();
    } catch (const Busy& error) {
      const std::string text = error.what();
      EXPECT_NE(text.find("sand.sqlite: another program keeps the database locked"), std::string::npos)
          << text;
      EXPECT_NE(text.find("close it there and run again"), std::string::npos) << text;
      return;
    }
    ADD_FAILURE() << "not busy";
  };
  busy([&] { (void)query(study.database, "realizations"); });
  busy([&] { (void)read_snapshot(study.database); });
  busy([&] { (void)open(study); });
}

TEST_F(PatienceTest, TheInnermostCounts) {
  const Patience outer([](const auto&, double) { return true; });
  EXPECT_TRUE(Patience::lasts("a", 1e9));
  {
    const Patience inner([](const auto&, double seconds) { return seconds < 1.0; });
    EXPECT_FALSE(Patience::lasts("a", 1.0));
  }
  EXPECT_TRUE(Patience::lasts("a", 1e9));
}

// Another process, in both journals that a campaign uses.
TEST_F(PatienceTest, TheProgramThatKeepsItIsNamed) {
  for (const char* lock :
       {"PRAGMA journal_mode = DELETE; BEGIN EXCLUSIVE", "PRAGMA journal_mode = WAL; BEGIN IMMEDIATE"}) {
    int ready[2];
    int done[2];
    ASSERT_EQ(::pipe(ready), 0);
    ASSERT_EQ(::pipe(done), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(done[1]);
      const Database browser = other();
      browser.execute(lock);
      char byte = 'x';
      (void)!::write(ready[1], &byte, 1);
      (void)!::read(done[0], &byte, 1);  // until the parent closes its end
      std::_Exit(0);
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    const std::string who = who_keeps(study.database);
    for (const int end : {ready[0], ready[1], done[0], done[1]}) ::close(end);
    ::waitpid(child, nullptr, 0);
    if (who == "another program") GTEST_SKIP() << "this system does not tell who holds a lock";
    EXPECT_EQ(who, "process " + std::to_string(child) + " (results_tests)") << lock;
  }
  EXPECT_EQ(who_keeps(study.database), "another program") << "nobody holds it now";
}

TEST_F(PatienceTest, APathTooLongForSqliteIsTold) {
  std::filesystem::path deep = folder;
  while (deep.native().size() < 500) deep /= std::string(40, 'd');
  std::filesystem::create_directories(deep);
  study.database = deep / "sand.sqlite";
  try {
    (void)open(study);
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("bytes, and SQLite takes 504); move the study to a folder with a shorter path"),
              std::string::npos)
        << text;
  }
  EXPECT_TRUE(std::filesystem::is_empty(deep)) << "no lock is left";
}

TEST_F(PatienceTest, TheLongestPathThatSqliteTakesIsTaken) {
  std::filesystem::path deep = folder;
  while (504 - deep.native().size() > 150) deep /= std::string(40, 'd');
  std::filesystem::create_directories(deep);
  study.database = deep / (std::string(504 - deep.native().size() - 1 - 7, 's') + ".sqlite");
  ASSERT_EQ(study.database.native().size(), 504U);
  EXPECT_EQ(open(study).counts().total(), 8);
}

}  // namespace
}  // namespace cpt::results

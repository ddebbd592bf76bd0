// Campaigns with the solver itself, on pushes of a few millimetres: the same bits however they are run, also
// after a kill.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

constexpr const char* few_millimetres = R"(title = "A few millimetres"
profile = "homogeneous_sand"
preset = "quick"

[fixed]
"penetrometer.final_depth_m" = 0.0265

[parameters]
"sand.D_r_percent" = { baseline = 36, lower = 26, upper = 46 }
"chamber.wall" = { baseline = "rigid", alternative = "flexible" }

[[windows]]
name = "start"
from_m = 0.0235
to_m = 0.0255
)";

// Seconds a push, so that a signal finds one under way.
constexpr const char* some_centimetres = R"(title = "Some centimetres"
profile = "homogeneous_sand"
preset = "quick"

[fixed]
"penetrometer.final_depth_m" = 0.05

[parameters]
"sand.D_r_percent" = { baseline = 36, upper = 46 }

[[windows]]
name = "start"
from_m = 0.0235
to_m = 0.05
)";

// Everything in the database but times, after the campaign has been run by this command.
std::string database_of(const StudyFolder& folder) { return contents(folder.file("push.sqlite")); }

std::string run_undisturbed(const StudyFolder& folder, const char* study = few_millimetres) {
  folder.write("push.toml", study);
  const Result result = run(campaign({folder.file("push.toml"), "--slots", "1"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return database_of(folder);
}

TEST(RealSolver, RanksAndThreadsDoNotChangeABitAndRerunAgrees) {
  const StudyFolder one;
  const std::string expected = run_undisturbed(one);
  ASSERT_NE(expected.find("chamber.wall"), std::string::npos);
  for (const char* threads : {"1", "2"}) {
    const StudyFolder folder;
    folder.write("push.toml", few_millimetres);
    const Result result = run(mpirun(2, {folder.file("push.toml"), "--threads", threads, "--slots", "2"}));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(database_of(folder), expected) << threads << " threads";
  }
  for (const char* id : {"1", "4"}) {
    const Result rerun = run(campaign({"rerun", one.file("push.toml"), id}));
    EXPECT_EQ(rerun.exit_code, 0) << rerun.out << rerun.err;
    EXPECT_NE(rerun.out.find("identical bit for bit"), std::string::npos) << rerun.out;
  }
  EXPECT_TRUE(std::filesystem::exists(one.file("push-report/index.html")));
}

TEST(RealSolver, KilledCampaignResumesToTheSameBits) {
  const StudyFolder undisturbed, folder;
  const std::string expected = run_undisturbed(undisturbed);
  folder.write("push.toml", few_millimetres);
  const Command command = mpirun(2, {folder.file("push.toml"), "--slots", "1"});
  for (const std::size_t victim : {0U, 1U}) {  // master, worker
    Background job(command, {});
    for (int i = 0; i < 500; ++i) {  // until both ranks run a realization
      const auto ranks = children_of(job.pid());
      if (ranks.size() == 2 && !children_of(ranks[0]).empty() && !children_of(ranks[1]).empty()) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    const std::vector<pid_t> ranks = children_of(job.pid());
    ASSERT_EQ(ranks.size(), 2U);
    ASSERT_EQ(::kill(ranks[victim], SIGKILL), 0);
    EXPECT_NE(job.wait().exit_code, 0);
  }
  // A realization's own process: it alone is lost, and run again when asked.
  Background job(campaign({folder.file("push.toml"), "--slots", "1"}), {});
  std::vector<pid_t> running;
  for (int i = 0; i < 500 && running.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    running = children_of(job.pid());
  }
  ASSERT_FALSE(running.empty());
  ASSERT_EQ(::kill(running.front(), SIGKILL), 0);
  EXPECT_EQ(job.wait().exit_code, 1);
  const Result resumed = run(mpirun(2, {folder.file("push.toml"), "--retry-failed"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(database_of(folder), expected);
}

TEST(RealSolver, StoppedCampaignGoesOnFromItsCheckpoints) {
  const StudyFolder undisturbed, folder;
  const std::string expected = run_undisturbed(undisturbed, some_centimetres);
  EXPECT_FALSE(std::filesystem::exists(undisturbed.file("push.checkpoints"))) << "left over";
  folder.write("push.toml", some_centimetres);
  const Command command = campaign({folder.file("push.toml"), "--slots", "1", "--threads", "1"});
  std::string told;
  for (const int signal : {SIGTERM, SIGUSR1}) {
    Background job(command, {});
    for (int i = 0; i < 500 && children_of(job.pid()).empty(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    ASSERT_EQ(::kill(job.pid(), signal), 0);
    const Result result = job.wait();
    EXPECT_EQ(result.exit_code, 128 + signal) << result.err;
    told += result.err;
  }
  EXPECT_FALSE(std::filesystem::is_empty(folder.file("push.checkpoints")));
  const Result resumed = run(mpirun(2, {folder.file("push.toml"), "--threads", "2"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  told += resumed.err;
  EXPECT_NE(told.find("goes on from its checkpoint at"), std::string::npos) << told;
  EXPECT_EQ(database_of(folder), expected);
  EXPECT_FALSE(std::filesystem::exists(folder.file("push.checkpoints")));
}

}  // namespace
}  // namespace cpt::tests

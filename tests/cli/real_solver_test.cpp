// Campaigns with the solver itself, on pushes of a few millimetres: the same bits however they are run, also
// after a kill.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

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

// Everything in the database but times, after the campaign has been run by this command.
std::string database_of(const StudyFolder& folder) { return contents(folder.file("push.sqlite")); }

std::string run_undisturbed(const StudyFolder& folder) {
  folder.write("push.toml", hurried(few_millimetres));
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
    folder.write("push.toml", hurried(few_millimetres));
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

// Variables that hold every push half way down until the gate opens.
std::vector<std::string> gated(const StudyFolder& folder) {
  return {"CPT_GATE_DEPTH_m=0.0245", "CPT_GATE=" + folder.file("gate"),
          "CPT_GATE_LOG=" + folder.file("arrivals")};
}
// True once so many pushes have come to the gate.
bool arrived(const StudyFolder& folder, std::ptrdiff_t pushes) {
  return eventually([&] {
    const std::string log = folder.read("arrivals");
    return std::count(log.begin(), log.end(), '\n') == pushes;
  });
}

TEST(RealSolver, KilledCampaignResumesToTheSameBits) {
  const StudyFolder undisturbed, folder;
  const std::string expected = run_undisturbed(undisturbed);
  folder.write("push.toml", hurried(few_millimetres));
  const Command command = mpirun(2, {folder.file("push.toml"), "--slots", "1", "--executor", GATED_PUSH});
  std::ptrdiff_t arrivals = 0;
  for (const std::size_t victim : {0U, 1U}) {  // master, worker
    Background job(command, gated(folder));
    ASSERT_TRUE(arrived(folder, arrivals += 2));  // both ranks run one
    const std::vector<pid_t> ranks = children_of(job.pid());
    ASSERT_EQ(ranks.size(), 2U);
    ASSERT_EQ(::kill(ranks[victim], SIGKILL), 0);
    EXPECT_NE(job.wait().exit_code, 0);
  }
  // A realization's own process: it alone is lost, and run again when asked.
  Background job(campaign({folder.file("push.toml"), "--slots", "1", "--executor", GATED_PUSH}),
                 gated(folder));
  ASSERT_TRUE(arrived(folder, arrivals += 1));
  ASSERT_EQ(children_of(job.pid()).size(), 1U);
  ASSERT_EQ(::kill(children_of(job.pid()).front(), SIGKILL), 0);
  folder.write("gate", "");
  EXPECT_EQ(job.wait().exit_code, 1);
  const Result resumed = run(mpirun(2, {folder.file("push.toml"), "--retry-failed"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(database_of(folder), expected);
}

TEST(RealSolver, StoppedCampaignGoesOnFromItsCheckpoints) {
  const StudyFolder undisturbed, folder;
  const std::string expected = run_undisturbed(undisturbed);
  EXPECT_FALSE(std::filesystem::exists(undisturbed.file("push.checkpoints"))) << "left over";
  folder.write("push.toml", hurried(few_millimetres));
  const Command command =
      campaign({folder.file("push.toml"), "--slots", "1", "--threads", "1", "--executor", GATED_PUSH});
  std::string told;
  std::ptrdiff_t arrivals = 0;
  for (const int signal : {SIGTERM, SIGUSR1}) {
    Background job(command, gated(folder));
    ASSERT_TRUE(arrived(folder, arrivals += 1));
    ASSERT_EQ(::kill(job.pid(), signal), 0);
    const Result result = job.wait();
    EXPECT_EQ(result.exit_code, 128 + signal) << result.err;
    told += result.err;
    ASSERT_TRUE(std::filesystem::exists(folder.file("push.checkpoints"))) << result.err;
    EXPECT_FALSE(std::filesystem::is_empty(folder.file("push.checkpoints")));
  }
  const Result resumed = run(mpirun(2, {folder.file("push.toml"), "--threads", "2"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  told += resumed.err;
  EXPECT_NE(told.find("goes on from its checkpoint at"), std::string::npos) << told;
  EXPECT_EQ(database_of(folder), expected);
  EXPECT_FALSE(std::filesystem::exists(folder.file("push.checkpoints")));
}

// A checkpoint whose arrays have other names than this program's is told of once, and as what it is.
TEST(RealSolver, CheckpointOfNoUseStartsThePushAfresh) {
  const StudyFolder undisturbed, folder;
  const std::string expected = run_undisturbed(undisturbed);
  folder.write("push.toml", hurried(few_millimetres));
  Background job(
      campaign({folder.file("push.toml"), "--slots", "1", "--threads", "1", "--executor", GATED_PUSH}),
      gated(folder));
  ASSERT_TRUE(arrived(folder, 1));
  ASSERT_EQ(::kill(job.pid(), SIGTERM), 0);
  EXPECT_EQ(job.wait().exit_code, 128 + SIGTERM);
  int renamed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("push.checkpoints"))) {
    std::string bytes = folder.read("push.checkpoints/" + entry.path().filename().string());
    for (auto at = bytes.find("bins.q_c"); at != std::string::npos; at = bytes.find("bins.q_c", at + 1))
      bytes[at + 7] = 'd', ++renamed;
    std::ofstream(entry.path(), std::ios::binary) << bytes;
  }
  ASSERT_GT(renamed, 0);
  const Result resumed = run(campaign({folder.file("push.toml"), "--slots", "1", "--threads", "1"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("its checkpoint is of no use"), std::string::npos) << resumed.err;
  EXPECT_EQ(resumed.err.find("goes on from its checkpoint"), std::string::npos) << resumed.err;
  EXPECT_EQ(database_of(folder), expected);
}

}  // namespace
}  // namespace cpt::tests

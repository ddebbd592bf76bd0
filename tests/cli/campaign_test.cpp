// Campaigns from the command line, with a stand-in for the solver: same results on any number of ranks,
// failures on record, kills survived.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <sstream>

#include "tests/cli/program.hpp"

namespace cpt::tests {
namespace {

constexpr int realizations = 6;

std::vector<std::string> arguments(const std::string& study, std::vector<std::string> more = {}) {
  std::vector<std::string> words{study, "--executor", FAKE_REALIZATION, "--no-report"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string undisturbed() {
  const StudyFolder folder;
  EXPECT_EQ(run(campaign(arguments(folder.study()))).exit_code, 0);
  return contents(folder.file("small.sqlite"));
}

// Starts of realizations on the stand-in's log, each as the hash of its settings.
std::vector<std::string> starts(const StudyFolder& folder, const std::string& log) {
  std::istringstream lines(folder.read(log));
  std::vector<std::string> hashes;
  for (std::string pid, hash; lines >> pid >> hash;) hashes.push_back(hash);
  return hashes;
}

// True once so many realizations are completed and so many have been started.
bool held_up(const StudyFolder& folder, std::size_t completed, std::size_t started) {
  return eventually([&] {
    if (starts(folder, "first.log").size() != started) return false;
    const Result answer = run(
        campaign({"query", folder.file("small.sqlite"), "sql",
                  "select count(*) as n from realization where status = 'completed'", "--format", "csv"}));
    return answer.out.find(std::to_string(completed)) != std::string::npos;
  });
}

// Variables that make the realizations with these values wait until the gate opens.
std::vector<std::string> gated(const StudyFolder& folder, const std::vector<std::string>& values) {
  std::string rules = "CPT_FAKE=";
  for (const std::string& value : values) rules += value + ":wait;";
  return {rules, "CPT_FAKE_GATE=" + folder.file("gate"), "CPT_FAKE_LOG=" + folder.file("first.log")};
}
// The last two of the six (parameters/run_order.hpp), so that two ranks complete four and are then held up.
const std::vector<std::string> last_two{"sand.nu=0.1", "sand.nu=0.3"};

TEST(Campaign, WatchedReportFollowsItToItsEnd) {
  const StudyFolder folder;
  Background job(mpirun(2, arguments(folder.study(), {"--slots", "1"})), gated(folder, last_two));
  ASSERT_TRUE(held_up(folder, 4, 6));
  Background watch(campaign({"report", folder.study(), "--watch", "--every", "0.2"}), {});
  const std::filesystem::path page = folder.file("small-report/index.html");
  const auto says = [&](const char* text) {
    return std::filesystem::exists(page) &&
           folder.read("small-report/index.html").find(text) != std::string::npos;
  };
  EXPECT_TRUE(
      eventually([&] { return says("\"state\":\"4 of 6 realizations completed, 2 still to run\""); }));
  EXPECT_TRUE(says("\"reload_seconds\":1"));
  folder.write("gate", "");
  EXPECT_EQ(job.wait().exit_code, 0);
  const Result watched = watch.wait();
  EXPECT_EQ(watched.exit_code, 0) << watched.err;
  EXPECT_TRUE(says("\"state\":\"6 of 6 realizations completed\""));
  EXPECT_TRUE(says("\"reload_seconds\":0"));
  const Result numbers =
      run(campaign({"query", folder.file("small.sqlite"), "sql",
                    "select q_c_mean_kPa from window_mean order by realization", "--format", "csv"}));
  std::istringstream lines(numbers.out);
  std::string line;
  std::getline(lines, line);  // the heading
  int means = 0;
  while (std::getline(lines, line)) {
    EXPECT_TRUE(says(("\"q_c_mean_kPa\":" + line + ",").c_str())) << line;
    ++means;
  }
  EXPECT_EQ(means, 6);
}

TEST(Campaign, EndsWithAllRealizationsCompleted) {
  const StudyFolder folder;
  const Result result = run(campaign(arguments(folder.study())));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.out.find("6 of 6 realizations completed, 0 failed"), std::string::npos) << result.out;
  EXPECT_NE(result.err.find("[6/6] realization"), std::string::npos) << result.err;
  EXPECT_TRUE(std::filesystem::exists(folder.file("small.h5")));
}

TEST(Campaign, RanksSlotsAndThreadsDoNotChangeTheDatabase) {
  const std::string expected = undisturbed();
  ASSERT_GT(expected.size(), 1000U);
  for (const Command& command : {mpirun(1, {}), mpirun(2, {}), mpirun(3, {}), campaign({"--slots", "3"}),
                                 mpirun(2, {"--threads", "2"})}) {
    const StudyFolder folder;
    Command words = command;
    // The study follows the program's own name, options come last.
    const auto program = std::find(words.begin(), words.end(), campaign({}).front());
    const std::vector<std::string> more(program + 1, words.end());
    words.erase(program + 1, words.end());
    for (const std::string& word : arguments(folder.study(), more)) words.push_back(word);
    const Result result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(contents(folder.file("small.sqlite")), expected);
  }
}

TEST(Campaign, BothRanksWork) {
  const StudyFolder folder;
  Background job(mpirun(2, arguments(folder.study(), {"--slots", "1"})), gated(folder, {"*"}));
  EXPECT_TRUE(eventually([&] {
    const auto ranks = children_of(job.pid());
    return ranks.size() == 2 &&
           std::all_of(ranks.begin(), ranks.end(), [](pid_t rank) { return children_of(rank).size() == 1; });
  }));
  folder.write("gate", "");
  EXPECT_EQ(job.wait().exit_code, 0);
}

TEST(Campaign, FailuresAreOnRecordAndTheOthersGoOn) {
  const StudyFolder folder;
  const Result result = run(mpirun(2, arguments(folder.study(), {"--hang-limit", "15"})),
                            {"CPT_FAKE=sand.H=75:segfault;sand.nu=0.1:hang;sand.nu=0.3:garbage"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.out.find("3 of 6 realizations completed, 3 failed"), std::string::npos) << result.out;
  const std::string failures = run(campaign({"query", folder.study(), "failures", "--format", "csv"})).out;
  for (const char* part : {"crashed,killed by signal 11 (Segmentation fault)",
                           "time_limit,\"hung: no step for 15 s", "crashed,sent an unreadable answer"})
    EXPECT_NE(failures.find(part), std::string::npos) << failures;
}

TEST(Campaign, FailedRealizationsAreRunAgainOnlyWhenAsked) {
  const StudyFolder folder;
  EXPECT_EQ(run(campaign(arguments(folder.study())), {"CPT_FAKE=sand.H=75:throw"}).exit_code, 1);
  EXPECT_EQ(run(campaign(arguments(folder.study()))).exit_code, 1);
  EXPECT_EQ(run(campaign(arguments(folder.study(), {"--retry-failed"}))).exit_code, 0);
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());
}

TEST(Campaign, FinishedWorkIsNotDoneAgain) {
  const StudyFolder folder;
  const std::string log = "CPT_FAKE_LOG=" + folder.file("log");
  EXPECT_EQ(run(campaign(arguments(folder.study())), {log}).exit_code, 0);
  EXPECT_EQ(starts(folder, "log").size(), static_cast<std::size_t>(realizations));
  EXPECT_EQ(run(campaign(arguments(folder.study())), {log}).exit_code, 0);
  EXPECT_EQ(starts(folder, "log").size(), static_cast<std::size_t>(realizations));
}

TEST(Campaign, SecondInstanceIsRefused) {
  const StudyFolder folder;
  Background first(campaign(arguments(folder.study())), gated(folder, {"*"}));
  ASSERT_TRUE(eventually([&] { return !children_of(first.pid()).empty(); }));
  const Result second = run(campaign(arguments(folder.study())));
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_NE(second.err.find("small.sqlite"), std::string::npos) << second.err;
  EXPECT_EQ(run(mpirun(2, arguments(folder.study()))).exit_code, 3);
  ::kill(first.pid(), SIGTERM);
  EXPECT_EQ(first.wait().exit_code, 143);
}

class Signalled : public testing::TestWithParam<int> {};

TEST_P(Signalled, StopsCleanlyAndGoesOn) {
  const StudyFolder folder;
  Background job(campaign(arguments(folder.study(), {"--slots", "1"})),
                 gated(folder, {"sand.D_r_percent=46"}));
  ASSERT_TRUE(held_up(folder, 3, 4));
  const std::vector<pid_t> running = children_of(job.pid());
  ::kill(job.pid(), GetParam());
  const Result result = job.wait();
  EXPECT_EQ(result.exit_code, 128 + GetParam());
  EXPECT_NE(result.err.find("the same command goes on"), std::string::npos) << result.err;
  for (const pid_t pid : running) EXPECT_FALSE(alive(pid)) << "a realization outlived the campaign";
  EXPECT_EQ(run(campaign(arguments(folder.study()))).exit_code, 0);
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());
}

INSTANTIATE_TEST_SUITE_P(Signals, Signalled, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGUSR1));

enum class Victim { launcher, master, worker, realization };
class Killed : public testing::TestWithParam<Victim> {};

pid_t find(Victim victim, pid_t launcher) {
  if (victim == Victim::launcher) return launcher;
  const std::vector<pid_t> ranks = children_of(launcher);  // started in the order of their ranks
  if (victim == Victim::master) return ranks.at(0);
  if (victim == Victim::worker) return ranks.at(1);
  const std::vector<pid_t> running = children_of(ranks.at(1));
  return running.empty() ? -1 : running.front();
}

TEST_P(Killed, ResumedCampaignEndsAsAnUndisturbedOne) {
  const StudyFolder folder;
  Background job(mpirun(2, arguments(folder.study(), {"--slots", "1"})), gated(folder, last_two));
  ASSERT_TRUE(held_up(folder, 4, 6));
  const std::vector<pid_t> ranks = children_of(job.pid());
  ASSERT_EQ(ranks.size(), 2U);
  const pid_t victim = find(GetParam(), job.pid());
  ASSERT_GT(victim, 0);
  ASSERT_EQ(::kill(victim, SIGKILL), 0);
  if (GetParam() == Victim::realization) folder.write("gate", "");  // the campaign goes on without it
  const Result result = job.wait();
  EXPECT_NE(result.exit_code, 0);
  ASSERT_TRUE(eventually([&] { return std::none_of(ranks.begin(), ranks.end(), alive); }))
      << "ranks go with their job";

  std::vector<std::string> resume;
  if (GetParam() == Victim::realization) {
    // Only this one is lost, with its reason; the campaign has gone on to its end.
    EXPECT_EQ(result.exit_code, 1);
    const std::string failures = run(campaign({"query", folder.study(), "failures"})).out;
    EXPECT_NE(failures.find("killed by signal 9"), std::string::npos) << failures;
    resume.emplace_back("--retry-failed");
  }
  const Result resumed =
      run(mpirun(2, arguments(folder.study(), resume)), {"CPT_FAKE_LOG=" + folder.file("second.log")});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());

  // Only what was lost is started again.
  const std::size_t lost = GetParam() == Victim::realization ? 1 : 2;
  EXPECT_EQ(starts(folder, "first.log").size(), static_cast<std::size_t>(realizations));
  EXPECT_EQ(starts(folder, "second.log").size(), lost);
}

std::string name_of(const testing::TestParamInfo<Victim>& instance) {
  constexpr const char* names[] = {"launcher", "master", "worker", "realization"};
  return names[static_cast<int>(instance.param)];
}
INSTANTIATE_TEST_SUITE_P(Processes, Killed,
                         testing::Values(Victim::launcher, Victim::master, Victim::worker,
                                         Victim::realization),
                         name_of);

TEST(Campaign, LostRankIsReplacedWhereTheLauncherLetsTheOthersLive) {
  const StudyFolder folder;
  Background job(
      mpirun(2, arguments(folder.study(), {"--slots", "1", "--rank-limit", "15"}), {"--enable-recovery"}),
      gated(folder, last_two));
  ASSERT_TRUE(held_up(folder, 4, 6));
  ASSERT_EQ(::kill(find(Victim::worker, job.pid()), SIGKILL), 0);
  folder.write("gate", "");
  const Result result = job.wait();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("rank 1 has been silent for 15 s"), std::string::npos) << result.err;
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());
}

TEST(Campaign, WorkerToldToStopLeavesItsWorkToTheOthers) {
  const StudyFolder folder;
  Background job(mpirun(2, arguments(folder.study(), {"--slots", "1"})), gated(folder, last_two));
  ASSERT_TRUE(held_up(folder, 4, 6));
  ASSERT_EQ(::kill(find(Victim::worker, job.pid()), SIGTERM), 0);
  folder.write("gate", "");
  const Result result = job.wait();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_NE(result.err.find("rank 1 was told to stop"), std::string::npos) << result.err;
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());
}

TEST(Campaign, RealizationToldToEndFromOutsideRunsAgainAtMostThrice) {
  const StudyFolder folder;
  Background job(campaign(arguments(folder.study(), {"--slots", "1"})),
                 gated(folder, {"sand.D_r_percent=46"}));
  for (std::size_t times = 1; times <= 3; ++times) {
    ASSERT_TRUE(held_up(folder, 3, 3 + times));
    ASSERT_TRUE(eventually([&] { return !children_of(job.pid()).empty(); }));
    ::kill(children_of(job.pid()).front(), times % 2 == 0 ? SIGTERM : SIGUSR1);
  }
  const Result result = job.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("realization 6 was told to end from outside; it starts again"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("crashed after 0 s: told to end from outside 3 times"), std::string::npos)
      << result.err;
  EXPECT_EQ(run(campaign(arguments(folder.study(), {"--retry-failed"}))).exit_code, 0);
  EXPECT_EQ(contents(folder.file("small.sqlite")), undisturbed());
}

TEST(Campaign, RerunComparesBitForBit) {
  const StudyFolder folder;
  ASSERT_EQ(run(campaign(arguments(folder.study())), {"CPT_FAKE=sand.H=75:energy_drift"}).exit_code, 1);
  const auto rerun = [&](const char* id, const char* fake) {
    return run(campaign({"rerun", folder.study(), id, "--executor", FAKE_REALIZATION}),
               {std::string("CPT_FAKE=") + fake});
  };
  const Result same = rerun("2", "");
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("identical bit for bit"), std::string::npos) << same.out;
  const Result same_failure = rerun("4", "*:energy_drift");
  EXPECT_EQ(same_failure.exit_code, 0) << same_failure.out << same_failure.err;
  const Result other_bits = rerun("2", "*:one_bit");
  EXPECT_EQ(other_bits.exit_code, 4);
  EXPECT_NE(other_bits.out.find("differs first in depth bin 3"), std::string::npos) << other_bits.out;
  EXPECT_EQ(rerun("2", "*:segfault").exit_code, 4);
  EXPECT_EQ(rerun("77", "").exit_code, 2);
}

TEST(Campaign, DesignIsRunResumedAndRead) {
  const StudyFolder folder;
  folder.write("small.toml", folder.read("small.toml") + "\n[design]\nkind = \"morris\"\ntrajectories = 3\n");
  const auto effects = [&] {
    const Result answer = run(campaign({"query", folder.study(), "effects", "--format", "csv"}));
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    return answer.out;
  };
  // Failing runs are left out, and run again on request.
  const Result first = run(campaign(arguments(folder.study())), {"CPT_FAKE=sand.nu=0.3:energy_drift"});
  EXPECT_EQ(first.exit_code, 1) << first.err;
  EXPECT_NE(effects().find("runs failed"), std::string::npos) << effects();
  EXPECT_EQ(run(campaign(arguments(folder.study(), {"--retry-failed"}))).exit_code, 0);
  const std::string whole = effects();
  EXPECT_EQ(whole.find("failed"), std::string::npos) << whole;
  EXPECT_EQ(std::count(whole.begin(), whole.end(), '\n'), 10) << whole;
  const Result again = run(campaign({"rerun", folder.study(), "8", "--executor", FAKE_REALIZATION}));
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  EXPECT_EQ(effects(), whole);
}

TEST(Campaign, EffectsOfAStudyWithoutDesignAreRefused) {
  const StudyFolder folder;
  EXPECT_EQ(run(campaign(arguments(folder.study()))).exit_code, 0);
  const Result answer = run(campaign({"query", folder.study(), "effects"}));
  EXPECT_EQ(answer.exit_code, 2);
  EXPECT_NE(answer.err.find("no [design]"), std::string::npos) << answer.err;
}

}  // namespace
}  // namespace cpt::tests

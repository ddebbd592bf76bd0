// Whatever a realization's process does becomes an outcome with a status and a reason.
#include "campaign/realization_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <thread>

#include "campaign/clock.hpp"
#include "campaign/executor.hpp"
#include "solver/presets.hpp"

namespace cpt::campaign {
namespace {

using solver::Status;

Order order(double wall_limit = 60.0, double hang_limit = 60.0) {
  return {5, 1, wall_limit, hang_limit,
          solver::make_setup(solver::Profile::homogeneous_sand, solver::Preset::quick)};
}

class Behaviour {
 public:
  Behaviour(const std::string& behaviour, const char* seconds) {
    ::setenv("CPT_FAKE", ("*:" + behaviour).c_str(), 1);
    ::setenv("CPT_FAKE_SECONDS", seconds, 1);
  }
  ~Behaviour() {
    ::unsetenv("CPT_FAKE");
    ::unsetenv("CPT_FAKE_SECONDS");
  }
};

solver::Outcome run(const std::string& behaviour, const Order& order, const char* seconds = "0.05") {
  const Behaviour environment(behaviour, seconds);
  RealizationProcess process({FAKE_REALIZATION}, order, monotonic_seconds());
  for (;;) {
    auto news = process.service(monotonic_seconds());
    if (news.outcome) return *news.outcome;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(RealizationProcess, ReturnsTheOutcome) {
  const solver::Outcome outcome = run("curve", order());
  EXPECT_EQ(outcome.status, Status::completed);
  EXPECT_EQ(outcome.reason, "");
  EXPECT_EQ(outcome.steps, 1000);
  EXPECT_GT(outcome.profile.q_c.size(), 100U);
}

TEST(RealizationProcess, EqualOrdersGiveEqualBits) {
  const solver::Outcome a = run("curve", order());
  const solver::Outcome b = run("curve", order());
  EXPECT_EQ(a.profile.q_c, b.profile.q_c);
}

// Runs until a report of progress satisfies the condition, on a clock that stands still.
template <class Condition>
void await_progress(RealizationProcess& process, Condition condition) {
  for (;;) {
    const auto news = process.service(0.0);
    ASSERT_FALSE(news.outcome) << news.outcome->reason;
    if (news.progress && condition(*news.progress)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

// What comes of a run once the clock has jumped to these times, one after the other.
solver::Outcome outcome_at(RealizationProcess& process, std::initializer_list<double> times) {
  for (auto time = times.begin();; time += time + 1 != times.end() ? 1 : 0) {
    auto news = process.service(*time);
    if (news.outcome) return *news.outcome;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(RealizationProcess, PassesProgressOn) {
  const Behaviour environment("deaf", "1000");
  RealizationProcess process({FAKE_REALIZATION}, order(), 0.0);
  std::vector<std::int64_t> steps;
  await_progress(process, [&](const solver::Progress& progress) {
    steps.push_back(progress.steps);
    return steps.size() == 3;
  });
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
}

TEST(RealizationProcess, FailuresOfTheSolverPassThrough) {
  const solver::Outcome outcome = run("energy_drift", order());
  EXPECT_EQ(outcome.status, Status::energy_drift);
  EXPECT_EQ(outcome.reason, "the fake drifts");
  EXPECT_FALSE(outcome.profile.q_c.empty());
}

struct Failure {
  const char* behaviour;
  const char* reason;  // a part of it
};
class RealizationProcessCrash : public testing::TestWithParam<Failure> {};

TEST_P(RealizationProcessCrash, IsRecordedWithItsReason) {
  const solver::Outcome outcome = run(GetParam().behaviour, order());
  EXPECT_EQ(outcome.status, Status::crashed);
  EXPECT_NE(outcome.reason.find(GetParam().reason), std::string::npos) << outcome.reason;
  EXPECT_TRUE(outcome.profile.q_c.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, RealizationProcessCrash,
    testing::Values(Failure{"segfault", "killed by signal 11 (Segmentation fault)"},
                    Failure{"out_of_memory",
                            "killed by signal 9 (Killed), as the system does when memory runs out"},
                    Failure{"throw", "exit code 1 without an outcome; its last words: the fake throws"},
                    Failure{"exit_3", "exit code 3 without an outcome"},
                    Failure{"garbage", "sent an unreadable answer: bytes that are no message"},
                    Failure{"half_message", "exit code 0 in the middle of its answer"},
                    Failure{"not_finite", "a completed run without a finite depth profile"},
                    Failure{"crash_at_exit", "killed by signal 6 (Aborted) after it had sent its outcome"}),
    [](const auto& instance) { return std::string(instance.param.behaviour); });

// Limits are held against a clock of the test's own: it jumps, and so does not care how fast the machine is.
TEST(RealizationProcess, HangEndsAtItsLimit) {
  const Behaviour environment("hang", "1000");
  RealizationProcess process({FAKE_REALIZATION}, order(60.0, 0.5), 0.0);
  await_progress(process, [](const auto&) { return true; });
  EXPECT_FALSE(process.service(0.4).outcome);
  const solver::Outcome outcome = outcome_at(process, {0.6, 10.0});
  EXPECT_EQ(outcome.status, Status::time_limit);
  EXPECT_NE(outcome.reason.find("hung: no step for 0.5 s"), std::string::npos) << outcome.reason;
}

TEST(RealizationProcess, WallLimitEndsARunThatMovesOn) {
  // The fake ignores its own limit, so the parent asks it to end: it does, and says how far it came.
  const Behaviour environment("curve", "10");
  RealizationProcess process({FAKE_REALIZATION}, order(0.2), 0.0);
  await_progress(process, [](const solver::Progress& progress) { return progress.steps > 0; });
  const solver::Outcome outcome = outcome_at(process, {5.0});
  EXPECT_EQ(outcome.status, Status::time_limit);
  EXPECT_NE(outcome.reason.find("reached its wall-clock limit of 0.2 s at depth"), std::string::npos)
      << outcome.reason;
  EXPECT_GT(outcome.steps, 0);
}

TEST(RealizationProcess, WallLimitKillsARunThatDoesNotListen) {
  const Behaviour environment("deaf", "1000");
  RealizationProcess process({FAKE_REALIZATION}, order(0.2), 0.0);
  await_progress(process, [](const auto&) { return true; });
  const solver::Outcome outcome = outcome_at(process, {5.0, 20.0});
  EXPECT_EQ(outcome.status, Status::time_limit);
  EXPECT_NE(outcome.reason.find("reached its wall-clock limit"), std::string::npos) << outcome.reason;
}

TEST(RealizationProcess, MissingProgramIsAnOutcomeToo) {
  RealizationProcess process({"/nowhere/at/all"}, order(), monotonic_seconds());
  const auto news = process.service(monotonic_seconds());
  ASSERT_TRUE(news.outcome);
  EXPECT_EQ(news.outcome->status, Status::crashed);
  EXPECT_NE(news.outcome->reason.find("cannot start /nowhere/at/all: No such file"), std::string::npos);
}

TEST(RealizationProcess, DestructionKillsTheProcess) {
  const Behaviour environment("hang", "1");
  pid_t pid = -1;
  {
    RealizationProcess process({FAKE_REALIZATION}, order(), monotonic_seconds());
    pid = process.pid();
    ASSERT_GT(pid, 0);
    EXPECT_EQ(::kill(pid, 0), 0);
  }
  EXPECT_EQ(::kill(pid, 0), -1);
}

TEST(RealizationProcess, DiesWithItsParent) {
  const Behaviour environment("hang", "1");
  int pipe_ends[2];
  ASSERT_EQ(::pipe(pipe_ends), 0);
  const pid_t parent = ::fork();
  if (parent == 0) {
    RealizationProcess process({FAKE_REALIZATION}, order(), monotonic_seconds());
    const pid_t pid = process.pid();
    while (!process.service(monotonic_seconds()).progress)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (::write(pipe_ends[1], &pid, sizeof pid) != sizeof pid) std::_Exit(1);
    ::raise(SIGKILL);
  }
  pid_t pid = -1;
  ASSERT_EQ(::read(pipe_ends[0], &pid, sizeof pid), static_cast<ssize_t>(sizeof pid));
  ASSERT_EQ(::waitpid(parent, nullptr, 0), parent);
  bool gone = false;
  for (int i = 0; i < 30'000 && !gone; ++i) {
    // Adopted by another process it may stay a zombie for a while, which has no command line.
    char link[64];
    std::snprintf(link, sizeof link, "/proc/%d/exe", pid);
    char target[8];
    gone = ::readlink(link, target, sizeof target) < 0;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(gone);
  ::close(pipe_ends[0]);
  ::close(pipe_ends[1]);
}

TEST(ProcessExecutor, RunsSeveralSideBySide) {
  const Behaviour environment("curve", "0.3");
  ProcessExecutor executor({{FAKE_REALIZATION}, {FAKE_REALIZATION}});
  const double start = monotonic_seconds();
  for (int id = 1; id <= 4; ++id) {
    Order one = order();
    one.realization = id;
    executor.start(one, start);
  }
  int outcomes = 0;
  while (executor.running() > 0) {
    executor.nap(0.2);
    for (const Message& message : executor.service(monotonic_seconds()))
      outcomes += std::holds_alternative<OutcomeReport>(message) ? 1 : 0;
  }
  EXPECT_EQ(outcomes, 4);
}

}  // namespace
}  // namespace cpt::campaign

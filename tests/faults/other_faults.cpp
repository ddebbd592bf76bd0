// Clocks that jump, studies that are edited, realizations that hang or have no memory, stops by a batch
// system.
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "tests/faults/trial.hpp"

namespace cpt::tests {
namespace {

constexpr const char* faketime = "/usr/lib/" LIBRARY_ARCHITECTURE "/faketime/libfaketime.so.1";

Finding jumping_clock(int trials, unsigned seed) {
  Finding finding{.fault = "the clock jumps by up to ten years while the campaign runs"};
  if (!std::filesystem::exists(faketime)) {
    finding.problems.emplace_back("libfaketime is not installed: not tried");
    return finding;
  }
  std::mt19937 random(seed);
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    trial.folder().write("clock", "+0d");
    std::vector<std::string> variables = trial.variables();
    variables.insert(variables.end(),
                     {std::string("LD_PRELOAD=") + faketime, "FAKETIME_DONT_FAKE_MONOTONIC=1",
                      "FAKETIME_NO_CACHE=1", "FAKETIME_TIMESTAMP_FILE=" + trial.folder().file("clock")});
    Background job(campaign(trial.arguments({"--slots", "1"})), variables);
    std::atomic<bool> running = true;
    std::thread jumps([&] {
      for (; running; std::this_thread::sleep_for(std::chrono::milliseconds(50)))
        trial.folder().write("clock", fmt::format("{:+}d", static_cast<int>(random() % 7300) - 3650));
    });
    const Result result = job.wait();
    running = false;
    jumps.join();
    trial.check(finding, result);
    expect(finding, result.exit_code == 0, "ended with " + result.err);
    expect(finding, contents(trial.database()) == undisturbed(Solver::stand_in).contents, "other results");
  }
  finding.told = "(nothing: only the times in the database show it)";
  return finding;
}

Finding edited_study(int trials, unsigned) {
  Finding finding{.fault = "the study is edited between two runs"};
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    expect(finding, run(campaign(trial.arguments()), trial.variables()).exit_code == 0, "did not run");
    const std::string study = trial.folder().read("faults.toml");
    std::string edited = study;
    edited.replace(edited.find("upper = 75"), 10, "upper = 70");
    trial.folder().write("faults.toml", edited);
    trial.folder().write("log", "");
    const Result result = run(campaign(trial.arguments()), trial.variables());
    ++finding.trials;
    finding.exit_codes.insert(result.exit_code);
    finding.told = line_with(result.err, "the study has changed");
    expect(finding, finding.told.find("sand.H, bounds: 25 to 70, was 25 to 75") != std::string::npos,
           "what changed is not told: " + result.err);
    const std::string log = trial.folder().read("log");
    expect(finding, std::count(log.begin(), log.end(), '\n') == 1,
           "other than the one changed was run: " + log);
    // Edited back: the run that was dropped meanwhile is used again.
    trial.folder().write("faults.toml", study);
    trial.folder().write("log", "");
    trial.finish(finding);
    const std::string again = trial.folder().read("log");
    expect(finding, again.empty(), "what had finished before the edit was run again: " + again);
  }
  return finding;
}

Finding hung_realization(int trials, unsigned) {
  Finding finding{.fault = "a realization hangs, deaf to signals"};
  while (finding.trials < trials) {
    Trial trial(Solver::stand_in);
    std::vector<std::string> variables = trial.variables();
    variables.emplace_back("CPT_FAKE=sand.H=75:hang");
    const Result result = run(campaign(trial.arguments({"--hang-limit", "10"})), variables);
    trial.check(finding, result);
    expect(finding, result.exit_code == 1, fmt::format("exit code {}", result.exit_code));
    finding.told = line_with(result.err, "hung");
    expect(finding, !finding.told.empty(), "the hang is not told");
    trial.finish(finding, {"--retry-failed"});
  }
  return finding;
}

// 'R', 'S', 'D', ... of /proc/PID/stat; 'Z' once it has ended.
char state_of(pid_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stat), {}};
  const auto end_of_name = text.rfind(')');
  return end_of_name == std::string::npos ? 'Z' : text.at(end_of_name + 2);
}

// Whether the program starts with so much memory [KiB]; without an order it ends at once. With a little too
// little, libraries hang as they load: asleep, while one that is only slow is running or waits for the disk.
bool starts_with(int limit) {
  Background job(
      {"/bin/sh", "-c", fmt::format("ulimit -v {}; exec {} realize 3<&-", limit, campaign({}).front())}, {});
  for (int asleep = 0; asleep < 200; std::this_thread::sleep_for(std::chrono::milliseconds(10))) {
    const char state = state_of(job.pid());
    if (state == 'Z') return job.wait().exit_code == 2;
    asleep = state == 'S' ? asleep + 1 : 0;
  }
  return false;
}

// The least memory [KiB] with which the program starts at all.
int memory_to_start() {
  int too_little = 20'000, enough = 1'000'000;
  while (enough - too_little > 500) {
    const int limit = (too_little + enough) / 2;
    (starts_with(limit) ? enough : too_little) = limit;
  }
  return enough;
}

Finding memory_limit(int trials, unsigned) {
  Finding finding{.fault = "a realization reaches its memory limit"};
  const int limit = memory_to_start();
  while (finding.trials < trials) {
    Trial trial(Solver::real);
    const std::string limited = trial.folder().file("limited");
    // Room for the program and its libraries; not for the material points.
    const int room = limit + 1000 * (2 + finding.trials % 3);
    trial.folder().write(
        "limited", fmt::format("#!/bin/sh\nulimit -v {}\nexec {} realize\n", room, campaign({}).front()));
    ::chmod(limited.c_str(), 0755);
    const Result result = run(campaign(trial.arguments({"--executor", limited})), trial.variables());
    trial.check(finding, result);
    expect(finding, result.exit_code == 1, fmt::format("exit code {}: {}", result.exit_code, result.err));
    finding.told = line_with(result.err, "memory");
    expect(finding, !finding.told.empty(), "the limit is not told: " + result.err);
    trial.finish(finding, {"--retry-failed"});
  }
  return finding;
}

// As a batch system does at the time limit: a signal to mpirun, or to every process there is.
Finding time_limit(int trials, unsigned seed) {
  Finding finding{.fault = "a batch system's time limit: SIGUSR1 or SIGTERM to mpirun or to all processes"};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  constexpr int stops_each = 2;  // of a campaign before it is let run to its end
  while (finding.trials < trials) {
    Trial trial(Solver::real);
    for (int stop = 0; stop < stops_each && finding.trials < trials; ++stop) {
      Background job(mpirun(2, trial.gated_arguments({"--slots", "1"})),
                     trial.gated_variables(share(random)));
      expect(finding, eventually([&] { return trial.at_gate() || !alive(job.pid()); }),
             "nothing was started");
      const int signal = stop == 0 ? SIGUSR1 : SIGTERM;
      std::vector<pid_t> all{job.pid()};
      if (random() % 2 == 0)
        for (const pid_t rank : children_of(job.pid())) {
          all.push_back(rank);
          for (const pid_t realization : children_of(rank)) all.push_back(realization);
        }
      for (const pid_t pid : all) ::kill(pid, signal);
      const Result result = job.wait();
      expect(finding, result.exit_code != 0, "it ended before the signal");
      trial.check(finding, result);
      if (const std::string line = line_with(result.err, "keeps its state"); !line.empty())
        finding.told = line;
    }
    trial.finish(finding);
  }
  return finding;
}

}  // namespace

std::vector<Fault> other_faults() {
  return {{"jumping_clock", 1, 10, jumping_clock},
          {"edited_study", 1, 3, edited_study},
          {"hung_realization", 1, 5, hung_realization},
          {"memory_limit", 1, 5, memory_limit},
          {"time_limit", 2, 20, time_limit}};
}

}  // namespace cpt::tests

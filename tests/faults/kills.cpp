// kill -9 at random moments.
#include <fmt/format.h>
#include <signal.h>

#include <memory>
#include <random>
#include <thread>
#include <tuple>

#include "tests/faults/trial.hpp"

namespace cpt::tests {
namespace {

constexpr double longest_start = 0.1;  // [s] a rank with the stand-in solver takes about so long

enum class Victim { master, worker, starting_rank, realization, group };

void add_descendants(pid_t pid, std::vector<pid_t>& all) {
  for (const pid_t child : children_of(pid)) {
    all.push_back(child);
    add_descendants(child, all);
  }
}

// Everything that mpirun started, itself included.
std::vector<pid_t> group_of(pid_t launcher) {
  std::vector<pid_t> all{launcher};
  add_descendants(launcher, all);
  return all;
}

// Whom to kill; empty if there is none at this moment.
std::vector<pid_t> find(Victim victim, pid_t launcher, std::mt19937& random) {
  if (victim == Victim::group) return group_of(launcher);
  const std::vector<pid_t> ranks = children_of(launcher);
  if (ranks.size() < 2) return {};
  if (victim == Victim::master) return {ranks[0]};
  if (victim == Victim::worker) return {ranks[1]};
  if (victim == Victim::starting_rank) return {ranks[random() % ranks.size()]};
  std::vector<pid_t> running = children_of(ranks[0]);
  for (const pid_t pid : children_of(ranks[1])) running.push_back(pid);
  if (running.empty()) return {};
  return {running[random() % running.size()]};
}

Finding kill_at_random(Victim victim, const std::string& name, Solver solver, int trials, unsigned seed) {
  Finding finding;
  finding.fault =
      fmt::format("kill -9 of {}{}", name, solver == Solver::real ? ", with the solver itself" : "");
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double longest = victim == Victim::starting_rank ? longest_start : 1.5 * undisturbed(solver).seconds;
  std::unique_ptr<Trial> trial;
  for (int attempt = 0; finding.trials < trials && attempt < 20 * trials; ++attempt) {
    if (!trial || trial->complete()) trial = std::make_unique<Trial>(solver);
    const Command command = mpirun(2, trial->gated_arguments({"--slots", "1", "--retry-failed"}));
    Background job(command, trial->gated_variables(share(random)));
    std::vector<pid_t> victims;
    const auto there = [&] {
      victims = find(victim, job.pid(), random);
      return !victims.empty() || !alive(job.pid());
    };
    std::ignore = eventually(there);
    std::this_thread::sleep_for(std::chrono::duration<double>(longest * share(random)));
    std::ignore = eventually(there);
    const std::vector<pid_t> everything = group_of(job.pid());
    for (const pid_t pid : victims) ::kill(pid, SIGKILL);
    trial->open_gate();  // for those that live on
    if (!eventually([&] { return !alive(job.pid()); })) {
      finding.problems.push_back("mpirun goes on without its ranks");
      for (const pid_t pid : everything) ::kill(pid, SIGKILL);
    }
    const Result result = job.wait();
    expect(finding, eventually([&] {
             for (const pid_t pid : everything)
               if (pid != job.pid() && alive(pid)) return false;
             return true;
           }),
           "processes were left over");
    Finding unhurt;  // a realization was just about to end
    trial->check(victims.empty() || result.exit_code == 0 ? unhurt : finding, result);
    for (const std::string& problem : unhurt.problems) finding.problems.push_back(problem);
    if (const std::string line = line_with(result.err, "killed"); !line.empty()) finding.told = line;
    if (finding.told.empty() && !line_with(result.err + result.out, "exited on signal 9").empty())
      finding.told = "mpirun: a process exited on signal 9 (Killed)";
    // Of a rank that was killed as it started mpirun may know no more.
    if (finding.told.empty()) finding.told = line_with(result.err + result.out, "aborted");
  }
  expect(finding, finding.trials == trials, fmt::format("only {} kills met their victim", finding.trials));
  if (trial) trial->finish(finding, {"--retry-failed"});
  if (victim == Victim::group) finding.told = "(nobody is left to tell)";
  return finding;
}

Fault kill_fault(const char* test, Victim victim, const char* name, Solver solver, int few, int many) {
  return {test, few, many,
          [=](int trials, unsigned seed) { return kill_at_random(victim, name, solver, trials, seed); }};
}

}  // namespace

std::vector<Fault> kills() {
  return {
      kill_fault("kill_master", Victim::master, "the master", Solver::stand_in, 3, 50),
      kill_fault("kill_worker", Victim::worker, "a worker", Solver::stand_in, 3, 50),
      kill_fault("kill_starting_rank", Victim::starting_rank, "a rank that starts", Solver::stand_in, 3, 50),
      kill_fault("kill_realization", Victim::realization, "a realization's process", Solver::stand_in, 3, 50),
      kill_fault("kill_group", Victim::group, "the whole group", Solver::stand_in, 3, 50),
      kill_fault("kill_master_real", Victim::master, "the master", Solver::real, 1, 3),
      kill_fault("kill_worker_real", Victim::worker, "a worker", Solver::real, 1, 3),
      kill_fault("kill_realization_real", Victim::realization, "a realization's process", Solver::real, 1, 3),
      kill_fault("kill_group_real", Victim::group, "the whole group", Solver::real, 1, 3)};
}

}  // namespace cpt::tests

#include "tests/faults/trial.hpp"

#include <fmt/format.h>

#include <chrono>
#include <sstream>

#include "results/ledger/provenance.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::tests {
namespace {

constexpr const char* stand_in_study = R"(title = "Faults"
profile = "homogeneous_sand"
preset = "quick"

[parameters]
"sand.nu" = { baseline = 0.2, lower = 0.1, upper = 0.3 }
"sand.H" = { baseline = 25, upper = 75 }
"sand.D_r_percent" = { baseline = 36, lower = 26, upper = 46 }
"sand.chi_tc" = { lower = 2.2, upper = 3.2 }
"sand.N" = { lower = 0.05, upper = 0.3 }
"contact.friction_ratio" = { lower = 0.3, upper = 0.9 }

[[windows]]
name = "deep"
from_m = 0.5054
to_m = 0.5255
)";

constexpr const char* real_study = R"(title = "Faults"
profile = "homogeneous_sand"
preset = "quick"

[fixed]
"penetrometer.final_depth_m" = 0.0265

[parameters]
"sand.D_r_percent" = { baseline = 36, lower = 26, upper = 46 }

[[windows]]
name = "start"
from_m = 0.0235
to_m = 0.0255
)";

std::string bytes_of(const solver::DepthProfile& profile) {
  std::string bytes;
  const auto append = [&](const std::vector<double>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
  };
  append(profile.depth);
  for (const solver::Channel& channel : solver::channels()) append(profile.*channel.values);
  return results::sha256(bytes);
}

Undisturbed run_undisturbed(Solver solver) {
  const Trial trial(solver);
  const auto start = std::chrono::steady_clock::now();
  const Result result = run(campaign(trial.arguments()), trial.variables());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (result.exit_code != 0) throw std::runtime_error("the undisturbed campaign failed: " + result.err);
  return {contents(trial.database()), seconds};
}

}  // namespace

Trial::Trial(Solver solver) : solver_(solver) {
  folder_.write("faults.toml", solver == Solver::real ? hurried(real_study) : stand_in_study);
}

std::vector<std::string> Trial::arguments(std::vector<std::string> more) const {
  std::vector<std::string> words{folder_.file("faults.toml"), "--no-report"};
  if (solver_ == Solver::stand_in) words.insert(words.end(), {"--executor", FAKE_REALIZATION});
  // Often enough for a kill to meet one being written.
  if (solver_ == Solver::real) words.insert(words.end(), {"--checkpoint", "0.1"});
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::vector<std::string> Trial::gated_arguments(std::vector<std::string> more) const {
  if (solver_ == Solver::real) more.insert(more.end(), {"--executor", GATED_PUSH});
  return arguments(std::move(more));  // the stand-in has a gate of its own
}

std::vector<std::string> Trial::variables() const {
  return {"CPT_FAKE_LOG=" + folder_.file("log"), "CPT_FAKE_SECONDS=0.05", "OMP_NUM_THREADS=1"};
}

std::vector<std::string> Trial::gated_variables(double place) const {
  std::filesystem::remove(folder_.file("gate"));
  std::filesystem::remove(folder_.file("arrivals"));
  std::vector<std::string> all = variables();
  for (const char* gate : {"CPT_GATE=", "CPT_FAKE_GATE="}) all.push_back(gate + folder_.file("gate"));
  all.push_back("CPT_GATE_LOG=" + folder_.file("arrivals"));
  all.push_back(fmt::format("CPT_GATE_DEPTH_m={:.6f}", 0.0226 + 0.0036 * place));
  all.emplace_back("CPT_FAKE=contact.friction_ratio=0.9:wait");
  return all;
}

void Trial::open_gate() const { folder_.write("gate", ""); }

bool Trial::at_gate() const { return !folder_.read("arrivals").empty(); }

void Trial::check(Finding& finding, const Result& result) {
  ++finding.trials;
  finding.exit_codes.insert(result.exit_code);
  for (const int unexpected : {2, 3, 5})
    expect(finding, result.exit_code != unexpected,
           fmt::format("exit code {}: {}", result.exit_code, result.err));
  const std::string log = folder_.read("log");
  std::istringstream lines(log.substr(std::min(log_read_, log.size())));
  log_read_ = log.size();
  for (std::string pid, hash; lines >> pid >> hash;)
    if (finished_.contains(hash)) {
      ++finding.twice;
      finding.problems.push_back("a finished realization was started again");
    }

  if (!std::filesystem::exists(database())) return;  // disturbed before there was one
  std::map<std::string, Finished> now;
  try {
    const results::Snapshot snapshot = results::read_snapshot(database());
    std::map<int, std::string> curves;
    for (const results::CurveRow& curve : snapshot.curves)
      curves[curve.realization] = bytes_of(curve.profile);
    for (const results::RealizationRow& row : snapshot.realizations)
      if (row.completed()) now[row.settings_hash] = {curves.at(row.id), row.finished};
  } catch (const std::exception& problem) {
    // One that was created just now holds nothing yet.
    if (finished_.empty() && std::string(problem.what()).find("not one of a campaign") != std::string::npos)
      return;
    ++finding.unopened;
    finding.problems.push_back(problem.what());
    return;
  }
  for (const auto& [hash, before] : finished_) {
    const auto still = now.find(hash);
    if (still == now.end() || still->second.curve != before.curve) {
      ++finding.lost;
      finding.problems.push_back("a finished realization was lost");
    } else if (still->second.when != before.when) {
      ++finding.twice;
      finding.problems.push_back("a finished realization was run again");
    }
  }
  finished_ = std::move(now);
}

bool Trial::complete() const {
  if (!std::filesystem::exists(database())) return false;
  try {
    for (const results::RealizationRow& row : results::read_snapshot(database()).realizations)
      if (!row.completed()) return false;
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

void Trial::finish(Finding& finding, const std::vector<std::string>& more) {
  const Result result = run(campaign(arguments(more)), variables());
  expect(finding, result.exit_code == 0,
         fmt::format("went on with exit code {}: {}", result.exit_code, result.err));
  expect(finding, contents(database()) == undisturbed(solver_).contents,
         "the database is not that of an undisturbed campaign");
}

const Undisturbed& undisturbed(Solver solver) {
  static const Undisturbed stand_in = run_undisturbed(Solver::stand_in);
  if (solver == Solver::stand_in) return stand_in;
  static const Undisturbed real = run_undisturbed(Solver::real);
  return real;
}

std::string line_with(const std::string& text, const std::string& part) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.find(part) != std::string::npos) return line;
  return {};
}

void expect(Finding& finding, bool condition, const std::string& problem) {
  if (!condition) finding.problems.push_back(problem);
}

}  // namespace cpt::tests

// Whole pushes of a few millimetres: material-point steps per second and core, memory, for each profile and
// preset.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace {

using namespace cpt::solver;

void push(benchmark::State& state, Profile profile, Preset preset) {
  Setup setup = make_setup(profile, preset);
  const int threads = static_cast<int>(state.range(0));
  // From the wished-in-place depth a short way down; the start is the costliest part in sand, where all of it
  // yields.
  setup.penetrometer.final_depth = 0.05;
  double point_steps = 0.0, seconds = 0.0;
  for (auto _ : state) {
    Observer observer;
    const Outcome outcome = simulate(setup, observer, {threads});
    if (outcome.status != Status::completed) {
      state.SkipWithError(outcome.reason.c_str());
      return;
    }
    point_steps += static_cast<double>(outcome.steps) * static_cast<double>(outcome.material_points);
    seconds += outcome.wall_seconds;
    state.SetIterationTime(outcome.wall_seconds);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["Mpoint-steps/s/core"] = point_steps / seconds / threads / 1e6;
  state.counters["peak_MiB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

[[maybe_unused]] const int registered = [] {
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets())
      benchmark::RegisterBenchmark(
          ("push/" + std::string(to_string(profile)) + "/" + std::string(to_string(preset))).c_str(), push,
          profile, preset)
          ->Arg(1)
          ->Arg(2)
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
  return 0;
}();

}  // namespace

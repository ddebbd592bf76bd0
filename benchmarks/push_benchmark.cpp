// Pushes of the cone as tables in Markdown, those of docs/benchmarks.md:
//
//   push/PROFILE/PRESET/THREADS      the first centimetres for each profile at three sizes
//   scaling/PROFILE/PRESET/FINER     the first steps on meshes refined FINER times: cost against points
//   whole/PROFILE/PRESET             whole pushes on one thread; minutes each
//   count/PROFILE/PRESET             the first millimetre, for scripts/count-flops
//
// --benchmark_filter=REGEX chooses (push/, scaling/, whole/.*paper ...), --benchmark_list_tests lists.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "benchmarks/machine.hpp"
#include "solver/material_points.hpp"
#include "solver/presets.hpp"
#include "solver/simulate.hpp"

namespace {

using namespace cpt;
using namespace cpt::solver;

/// Counts what the points and cells of a run occupy at its start.
class Census : public Observer {
 public:
  double next_look() const override { return slots > 0.0 ? std::numeric_limits<double>::infinity() : 0.0; }
  void look(double, const MaterialPoints& points) override {
    cells = points.bucket_count() / points.materials();
    for (std::int32_t b = 0; b < points.bucket_count(); ++b)
      slots += static_cast<double>(points.bucket(b).padded());
  }

  double slots = 0.0, cells = 0.0;
};

// Bytes of one step, counted: each field of a slot that a step reads or writes passes once, 14 in and 13 out;
// so do the sums (35 numbers), forces (37) and shape (6) of a cell.
double bytes_of_step(const Census& census) {
  return 8.0 * ((14 + 13) * census.slots + 2 * (35 + 37 + 6) * census.cells);
}

// Floating-point operations of the three stages of a step per material point, counted by scripts/count-flops
// on the AVX2 kernels: all lanes of what is executed, unused ones too. By profile and preset, in the order of
// all_profiles() and all_presets().
constexpr double flops_per_point_step[3][4] = {
    {1770, 0, 0, 0}, {495, 0, 0, 0}, {0, 0, 0, 0}};  // 0: not counted yet

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Peak memory of this process [bytes] since the last call to `forget_peak`; Linux only.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      double kibibytes = 0.0;
      status >> kibibytes;
      return 1024.0 * kibibytes;
    }
  return 0.0;
}

void forget_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

void run(benchmark::State& state, const Setup& setup, int threads) {
  for (auto _ : state) {
    Census census;
    forget_peak();
    const double before = processor_seconds();
    const Outcome outcome = simulate(setup, census, {threads});
    if (outcome.status != Status::completed) {
      state.SkipWithError(outcome.reason.c_str());
      return;
    }
    const double cpu = processor_seconds() - before, wall = outcome.wall_seconds;
    state.SetIterationTime(wall);
    const auto steps = static_cast<double>(outcome.steps),
               points = static_cast<double>(outcome.material_points);
    state.counters["points"] = points;
    state.counters["steps"] = steps;
    state.counters["wall"] = wall;
    state.counters["cpu"] = cpu;
    state.counters["speed"] = points * steps / wall / threads;
    state.counters["bytes"] = bytes_of_step(census) / points;
    state.counters["memory"] = peak_memory();
  }
}

void push(benchmark::State& state, Profile profile, Preset preset) {
  Setup setup = make_setup(profile, preset);
  // From the wished-in-place depth a short way down; the start is the costliest part in sand, where all of it
  // yields.
  setup.penetrometer.final_depth = 0.05;
  setup.numerics.step_levels = 0;  // every point at every step: what bytes and flops of a point-step count
  run(state, setup, static_cast<int>(state.range(0)));
  state.counters["flops"] = flops_per_point_step[static_cast<int>(profile)][static_cast<int>(preset)];
}

void whole(benchmark::State& state, Profile profile, Preset preset) {
  run(state, make_setup(profile, preset), 1);
}

void count(benchmark::State& state, Profile profile, Preset preset) {
  Setup setup = make_setup(profile, preset);
  const double start = setup.penetrometer.diameter / 2.0 / std::tan(setup.penetrometer.apex / 2.0);
  setup.penetrometer.final_depth = start + 0.001;
  setup.numerics.step_levels = 0;
  run(state, setup, 1);
}

// Cells and spacing of the points `finer` times smaller in both directions.
void scaling(benchmark::State& state, Profile profile, Preset preset) {
  Setup setup = make_setup(profile, preset);
  const auto finer = static_cast<int>(state.range(0));
  Numerics& numerics = setup.numerics;
  numerics.face_elements *= finer;
  for (double* size :
       {&numerics.near_height, &numerics.far_width, &numerics.below_height, &numerics.above_height})
    *size /= finer;
  for (PointZone& zone : numerics.zones) {
    zone.columns *= finer;
    zone.rows_per_metre *= finer;
  }
  const double start = setup.penetrometer.diameter / 2.0 / std::tan(setup.penetrometer.apex / 2.0);
  setup.penetrometer.final_depth = start + 0.004 / finer;  // about as many steps on every mesh
  numerics.step_levels = 0;
  run(state, setup, 1);
}

/// The runs of each kind as one table in Markdown.
class Tables : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const std::string& name = run.run_name.function_name;
      const std::string kind = name.substr(0, name.find('/'));
      if (kind != kind_) begin(kind);
      std::printf("| %s |", name.substr(kind.size() + 1).c_str());
      if (run.error_occurred)
        std::printf(" failed: %s |\n", run.error_message.c_str());
      else
        row(run.run_name.args, run.counters);
      std::fflush(stdout);
    }
  }

 private:
  void begin(const std::string& kind) {
    kind_ = kind;
    if (kind == "push") {
      std::printf("\nThis machine:");
      for (int t = 0; t < 2; ++t) {
        bandwidth_[t] = benchmarks::triad_bandwidth(t + 1);
        peak_[t] = benchmarks::peak_flops(t + 1);
        std::printf(" %s%.1f GB/s (triad), %.0f Gflop/s (multiply-adds) on %d thread%s", t > 0 ? "and " : "",
                    bandwidth_[t] / 1e9, peak_[t] / 1e9, t + 1, t > 0 ? "s.\n" : "");
      }
      columns({"push", "threads", "points", "million point-steps/s and core", "bytes per point-step",
               "share of triad", "flops per point-step", "share of peak", "peak memory"});
    } else if (kind == "scaling") {
      columns({"scaling", "finer", "points", "steps", "ns per point-step"});
    } else {
      columns({"whole push", "points", "steps", "wall [s]", "CPU [s]", "million point-steps/s"});
    }
  }

  static void columns(const std::vector<const char*>& names) {
    std::printf("\n|");
    for (const char* name : names) std::printf(" %s |", name);
    std::printf("\n|");
    for (std::size_t i = 0; i < names.size(); ++i) std::printf("---|");
    std::printf("\n");
  }

  void row(const std::string& argument, const benchmark::UserCounters& counters) const {
    const auto at = [&](const char* counter) { return counters.at(counter).value; };
    if (kind_ == "push") {
      const int threads = std::stoi(argument);
      const double rate = at("speed") * threads;
      std::printf(" %d | %.0f | %.1f | %.0f | %.0f %% |", threads, at("points"), at("speed") / 1e6,
                  at("bytes"), 100.0 * at("bytes") * rate / bandwidth_[threads - 1]);
      if (at("flops") > 0.0)
        std::printf(" %.0f | %.0f %% |", at("flops"), 100.0 * at("flops") * rate / peak_[threads - 1]);
      else
        std::printf(" not counted | |");
      std::printf(" %.0f MiB |\n", at("memory") / 1048576.0);
    } else if (kind_ == "scaling") {
      std::printf(" %s | %.0f | %.0f | %.1f |\n", argument.c_str(), at("points"), at("steps"),
                  1e9 / at("speed"));
    } else {
      std::printf(" %.0f | %.0f | %.0f | %.0f | %.1f |\n", at("points"), at("steps"), at("wall"), at("cpu"),
                  at("speed") / 1e6);
    }
  }

  std::string kind_;
  double bandwidth_[2] = {}, peak_[2] = {};
};

template <typename Function>
benchmark::internal::Benchmark* add(const char* kind, Function function, Profile profile, Preset preset) {
  const std::string name =
      std::string(kind) + "/" + std::string(to_string(profile)) + "/" + std::string(to_string(preset));
  return benchmark::RegisterBenchmark(name.c_str(), function, profile, preset)
      ->UseManualTime()
      ->Iterations(1);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) add("push", push, profile, preset)->Arg(1)->Arg(2);
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) {
      auto* const meshes = add("scaling", scaling, profile, preset)->Arg(1);
      if (preset == Preset::paper) meshes->Arg(2)->Arg(4);
    }
  for (const Profile profile : all_profiles())
    for (const Preset preset : all_presets()) {
      add("whole", whole, profile, preset);
      add("count", count, profile, preset);
    }

  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  Tables tables;
  benchmark::RunSpecifiedBenchmarks(&tables);
}

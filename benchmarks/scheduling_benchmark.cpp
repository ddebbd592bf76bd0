// What a realization costs beside its solver: whole campaigns of realizations that compute nothing, through
// the scheduler, transport, ledger and curve file of real ones.
//
//   mpirun -np RANKS scheduling_benchmark KIND REALIZATIONS SECONDS FOLDER
//
// KIND `inside`: realizations are made inside the ranks, which leaves the work of the master and the
// messages; `process`: each has a process of its own, as in a real campaign. A realization sleeps for SECONDS
// and gives a curve of as many bins as a whole push at the paper preset. Every rank has one slot. Prints a
// row of the table whose head `scheduling_benchmark` without arguments prints. Fails unless every realization
// ran exactly once and is in the database and in the curve file, both in FOLDER, which is made, or emptied of
// an earlier run.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/clock.hpp"
#include "campaign/mpi_transport.hpp"
#include "campaign/realization_child.hpp"
#include "campaign/run_campaign.hpp"
#include "campaign/stop_signals.hpp"
#include "campaign/worker.hpp"
#include "results/ledger/curve_store.hpp"
#include "results/ledger/snapshot.hpp"
#include "solver/quantities.hpp"

namespace {

using namespace cpt;

constexpr int bins = 1018;                                         // of a whole push at the paper preset
constexpr double progress_interval = 0.25;                         // [s] as of a realization's process
constexpr const char* seconds_variable = "CPT_BENCHMARK_SECONDS";  // for realizations' processes

// No work, but an outcome of the usual size.
solver::Outcome null_outcome(double seconds) {
  solver::Outcome outcome;
  outcome.status = solver::Status::completed;
  for (int bin = 0; bin < bins; ++bin) {
    outcome.profile.depth.push_back((bin + 0.5) * 0.0005);
    outcome.profile.q_c.push_back(1.0e6 * std::sqrt(outcome.profile.depth.back()));
    outcome.profile.f_s.push_back(1.0e4);
  }
  outcome.wall_seconds = seconds;
  return outcome;
}

void sleep_for(double seconds) {
  if (seconds <= 0.0) return;
  const auto whole = std::floor(seconds);
  const timespec time{static_cast<time_t>(whole), static_cast<long>((seconds - whole) * 1e9)};
  ::nanosleep(&time, nullptr);
}

/// Realizations inside the rank.
class RankExecutor final : public campaign::Executor {
 public:
  explicit RankExecutor(double seconds) : seconds_(seconds), outcome_(null_outcome(seconds)) {}

  void start(const campaign::Order& order, double now) override {
    running_[order.realization] = {now + seconds_, now};
  }
  std::vector<campaign::Message> service(double now) override {
    std::vector<campaign::Message> messages;
    for (auto item = running_.begin(); item != running_.end();) {
      auto& [id, run] = *item;
      if (now >= run.end) {
        messages.emplace_back(campaign::OutcomeReport{id, outcome_, false});
        item = running_.erase(item);
        continue;
      }
      if (now >= run.next_report) {
        run.next_report = now + progress_interval;
        messages.emplace_back(campaign::ProgressReport{id, {0.1, 0.2, 1, 1, 0.0}});
      }
      ++item;
    }
    return messages;
  }
  void nap(double seconds) const override {
    const double now = campaign::monotonic_seconds();
    for (const auto& [id, run] : running_) seconds = std::min(seconds, run.end - now);
    sleep_for(seconds);
  }
  void ask_all_to_end() override {}
  void kill_all() override { running_.clear(); }
  [[nodiscard]] std::size_t running() const override { return running_.size(); }

 private:
  struct Run {
    double end, next_report;  // [s]
  };
  double seconds_;
  solver::Outcome outcome_;
  std::map<int, Run> running_;
};

/// When a realization was started and when its outcome came [s].
struct Visit {
  int realization;
  double start, end;
};

/// Looks on.
class Witness final : public campaign::Executor {
 public:
  explicit Witness(campaign::Executor& inner) : inner_(inner) {}
  void start(const campaign::Order& order, double now) override {
    visits_.push_back({order.realization, campaign::monotonic_seconds(), 0.0});
    inner_.start(order, now);
  }
  std::vector<campaign::Message> service(double now) override {
    std::vector<campaign::Message> messages = inner_.service(now);
    for (const campaign::Message& message : messages)
      if (const auto* report = std::get_if<campaign::OutcomeReport>(&message))
        for (auto visit = visits_.rbegin(); visit != visits_.rend(); ++visit)
          if (visit->realization == report->realization) {
            visit->end = campaign::monotonic_seconds();
            break;
          }
    return messages;
  }
  void nap(double seconds) const override { inner_.nap(seconds); }
  void ask_all_to_end() override { inner_.ask_all_to_end(); }
  void kill_all() override { inner_.kill_all(); }
  [[nodiscard]] std::size_t running() const override { return inner_.running(); }
  [[nodiscard]] const std::vector<Visit>& visits() const { return visits_; }

 private:
  campaign::Executor& inner_;
  std::vector<Visit> visits_;
};

struct Job {
  std::string kind;
  int realizations;
  double seconds;
  std::filesystem::path folder;
};

// One baseline and points that differ in the hardening modulus.
parameters::Study make_study(const Job& job) {
  const std::filesystem::path& folder = job.folder;
  parameters::Study study;
  study.file = folder / "benchmark.toml";
  study.name = study.title = "benchmark";
  study.profile = solver::Profile::homogeneous_sand;
  study.preset = solver::Preset::paper;
  study.baseline = solver::make_setup(study.profile, study.preset);
  const solver::Quantity* H = solver::find_quantity("sand.H");
  for (int i = 1; i < job.realizations; ++i)
    study.points.push_back({fmt::format("point {}", i), {{H, 30.0 + 40.0 * i / job.realizations}}});
  study.windows = {{"deep", parameters::Window::Kind::fixed, 0.30, 0.32, 0.0},
                   {"peak", parameters::Window::Kind::peak, 0.10, 0.20, 0.010}};
  study.database = folder / "benchmark.sqlite";
  study.curves = folder / "benchmark.h5";
  study.report_dir = folder / "benchmark-report";
  study.wall_limit_seconds = std::numeric_limits<double>::infinity();
  return study;
}

std::filesystem::path visits_file(const Job& job, int rank) {
  return job.folder / fmt::format("visits-{}", rank);
}

long peak_memory() {  // [KiB]
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

void write_visits(const Job& job, int rank, const std::vector<Visit>& visits) {
  std::ofstream out(visits_file(job, rank));
  out << peak_memory() << '\n';
  for (const Visit& visit : visits)
    out << fmt::format("{} {:.9f} {:.9f}\n", visit.realization, visit.start, visit.end);
}

/// What the ranks did, from all their files.
struct Record {
  double first_start = std::numeric_limits<double>::infinity(), last_end = 0.0;  // [s]
  std::vector<double> gaps;  // [s] between an outcome and the rank's next start, rising
  std::vector<int> times;    // that each realization ran; by id
  long worker_memory = 0;    // [KiB] the largest
};

Record read_record(const Job& job, int ranks) {
  Record record;
  record.times.resize(static_cast<std::size_t>(job.realizations) + 1);
  for (int rank = 0; rank < ranks; ++rank) {
    std::ifstream in(visits_file(job, rank));
    long memory = 0;
    if (!(in >> memory)) throw std::runtime_error(fmt::format("rank {} left no record", rank));
    if (rank > 0) record.worker_memory = std::max(record.worker_memory, memory);
    double before = 0.0;
    for (Visit visit{}; in >> visit.realization >> visit.start >> visit.end;) {
      ++record.times.at(static_cast<std::size_t>(visit.realization));
      record.first_start = std::min(record.first_start, visit.start);
      record.last_end = std::max(record.last_end, visit.end);
      if (before > 0.0) record.gaps.push_back(visit.start - before);
      before = visit.end;
    }
  }
  std::sort(record.gaps.begin(), record.gaps.end());
  return record;
}

bool every_one_once(const Job& job, const Record& record) {
  const parameters::Study study = make_study(job);
  const auto count = static_cast<std::size_t>(job.realizations);
  const bool run_once =
      std::all_of(record.times.begin() + 1, record.times.end(), [](int n) { return n == 1; });
  const results::Snapshot snapshot = results::read_snapshot(study.database);
  const bool completed = std::all_of(snapshot.realizations.begin(), snapshot.realizations.end(),
                                     [](const results::RealizationRow& row) { return row.completed(); });
  const std::size_t mirrored = results::read_curves(study.curves).size();
  if (run_once && completed && snapshot.realizations.size() == count && snapshot.curves.size() == count &&
      mirrored == count)
    return true;
  fmt::print(stderr, "not every realization ran exactly once: {} rows, {} curves, {} in the curve file\n",
             snapshot.realizations.size(), snapshot.curves.size(), mirrored);
  return false;
}

void print_head() {
  fmt::print(
      "| realizations | ranks | seconds each | where | realizations/s | with the curve file | master's CPU "
      "us a "
      "realization: messages | database | scheduling | curve file | wall us | gap ms, median | 99 % | "
      "efficiency | "
      "with start and end | MiB, master | worker |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print_row(const Job& job, int ranks, const campaign::MasterTime& time, const Record& record,
               double whole, long memory) {
  const double n = job.realizations;
  const auto each = [&](double seconds) { return 1e6 * seconds / n; };
  const auto gap = [&](double part) {
    if (record.gaps.empty()) return 0.0;
    return 1e3 * record.gaps[static_cast<std::size_t>(part * static_cast<double>(record.gaps.size() - 1))];
  };
  const double busy = job.seconds * n / ranks;
  const double scheduling = time.whole.processor - time.messages.processor - time.database.processor -
                            time.realizations.processor - time.curves.processor - time.waiting.processor;
  fmt::print(
      "| {} | {} | {:g} | {} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | "
      "{:.1f} |",
      job.realizations, ranks, job.seconds, job.kind, n / (time.whole.wall - time.curves.wall),
      n / time.whole.wall, each(time.messages.processor), each(time.database.processor), each(scheduling),
      each(time.curves.processor), each(time.whole.wall - time.waiting.wall), gap(0.5), gap(0.99));
  if (busy > 0.0)
    fmt::print(" {:.3f} | {:.3f} |", busy / (record.last_end - record.first_start), busy / whole);
  else
    fmt::print(" | |");
  fmt::print(" {:.0f} | {:.0f} |\n", static_cast<double>(memory) / 1024.0,
             static_cast<double>(record.worker_memory) / 1024.0);
}

campaign::MasterTime run(const Job& job, campaign::Transport& transport, campaign::Executor& executor,
                         const campaign::RunOptions& options) {
  const campaign::Dismissal dismissal(transport);
  std::filesystem::remove_all(job.folder);
  std::filesystem::create_directories(job.folder);
  // The lines that a user would read are made and go nowhere.
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> nowhere(std::fopen("/dev/null", "w"), std::fclose);
  campaign::ProgressDisplay display(nowhere.get(), campaign::ProgressDisplay::Style::plain);
  return campaign::run_campaign(make_study(job), "", transport, executor, options, display).time;
}

int benchmark(const Job& job, std::unique_ptr<campaign::Transport> transport, double start) {
  campaign::RunOptions options;
  options.slots = 1;
  ::setenv(seconds_variable, fmt::format("{}", job.seconds).c_str(), 1);
  RankExecutor inside(job.seconds);
  campaign::ProcessExecutor processes({{"/proc/self/exe", "realize"}, {"/proc/self/exe", "realize"}});
  Witness executor(job.kind == "inside" ? static_cast<campaign::Executor&>(inside) : processes);
  const int rank = transport->rank(), ranks = transport->size();
  if (rank != 0) {
    campaign::serve_master(*transport, executor, options);
    write_visits(job, rank, executor.visits());
    return 0;
  }
  const campaign::MasterTime time = run(job, *transport, executor, options);
  write_visits(job, rank, executor.visits());
  const long memory = peak_memory();
  transport.reset();  // waits for the other ranks
  const double whole = campaign::monotonic_seconds() - start;
  const Record record = read_record(job, ranks);
  print_row(job, ranks, time, record, whole, memory);
  return every_one_once(job, record) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "realize")
    return campaign::serve_realization([](const solver::Setup&, solver::Observer&, const solver::Execution&) {
      const double seconds = std::stod(std::getenv(seconds_variable));
      sleep_for(seconds);
      return null_outcome(seconds);
    });
  const double start = campaign::monotonic_seconds();
  if (argc == 1) {
    print_head();
    return 0;
  }
  if (argc != 5 || (std::string_view(argv[1]) != "inside" && std::string_view(argv[1]) != "process")) {
    fmt::print(stderr, "scheduling_benchmark inside|process REALIZATIONS SECONDS FOLDER\n");
    return 2;
  }
  const Job job{argv[1], std::stoi(argv[2]), std::stod(argv[3]),
                std::filesystem::path(argv[4]) / "scheduling-benchmark"};
  const campaign::StopSignals signals;
  if (campaign::started_by_mpi()) return benchmark(job, std::make_unique<campaign::MpiTransport>(), start);
  return benchmark(job, std::make_unique<campaign::InProcessTransport>(), start);
}

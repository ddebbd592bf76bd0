#include "campaign/external/run_program.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "campaign/clock.hpp"
#include "campaign/external/program_process.hpp"
#include "campaign/external/program_results.hpp"
#include "campaign/last_words.hpp"
#include "campaign/order_server.hpp"

namespace cpt::campaign {
namespace {

namespace fs = std::filesystem;

constexpr double look_interval = 0.25;    // [s] between two looks at what the program has written
constexpr double after_asking = 1.0;      // [s] from asking the program to end to killing it
constexpr std::size_t last_words = 4096;  // [bytes] of standard error that are looked at

/// Why a run is no good.
struct Failed {
  solver::Status status;
  std::string reason;
};

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush())
    throw Failed{solver::Status::crashed, fmt::format("{} cannot be written", file.string())};
}

// "; its last words: ...", from the end of standard error.
std::string said(const fs::path& errors) {
  std::ifstream stream(errors, std::ios::binary | std::ios::ate);
  if (!stream) return "";
  const auto size = static_cast<std::streamoff>(stream.tellg());
  std::string tail(static_cast<std::size_t>(std::min<std::streamoff>(size, last_words)), '\0');
  stream.seekg(size - static_cast<std::streamoff>(tail.size()));
  stream.read(tail.data(), static_cast<std::streamsize>(tail.size()));
  const std::string line = last_line(tail);
  return line.empty() ? "" : fmt::format("; its last words: {}", line);
}

/// What lies in a folder; another one after every write.
struct Written {
  double bytes = 0.0;
  fs::file_time_type newest = fs::file_time_type::min();
  bool operator==(const Written&) const = default;
};

Written written_in(const fs::path& folder) {
  Written written;
  std::error_code gone;
  for (fs::recursive_directory_iterator entry(folder, gone), end; entry != end; entry.increment(gone)) {
    if (gone) break;
    if (!entry->is_regular_file(gone) || entry->is_symlink(gone)) continue;
    if (const auto size = entry->file_size(gone); !gone) written.bytes += static_cast<double>(size);
    if (const auto time = entry->last_write_time(gone); !gone)
      written.newest = std::max(written.newest, time);
  }
  return written;
}

class Try {
 public:
  Try(const Order& order, const ProgramWatch& watch, double ends)
      : order_(order), program_(*order.setup.program), watch_(watch), folder_(order.work), ends_(ends) {}

  /// Throws Failed.
  std::vector<solver::ProgramResult> run() {
    prepare();
    const int status = let_run();
    const double size = written_in(folder_).bytes;
    if (size >= program_.limits.most_bytes) throw too_much();
    if (WIFSIGNALED(status))
      throw WTERMSIG(status) == SIGXFSZ ? too_much() : crashed(killed_by(WTERMSIG(status)));
    if (WEXITSTATUS(status) != 0) throw crashed(fmt::format("exit code {}", WEXITSTATUS(status)));
    return results();
  }

 private:
  [[nodiscard]] Failed failed(solver::Status status, const std::string& reason) const {
    return {status, reason + said(folder_ / "stderr.txt")};
  }
  [[nodiscard]] Failed crashed(const std::string& reason) const {
    return failed(solver::Status::crashed, reason);
  }
  [[nodiscard]] Failed too_much() const {
    return crashed(fmt::format("wrote more than {:g} MB", program_.limits.most_bytes / 1.0e6));
  }

  void prepare() {
    std::error_code problem;
    fs::remove_all(folder_, problem);
    fs::create_directories(folder_, problem);
    if (problem)
      throw Failed{solver::Status::crashed,
                   fmt::format("its work folder {} cannot be made: {}", folder_.string(), problem.message())};
    std::string inputs = "{", filled = program_.template_text;
    for (std::size_t k = 0; k < program_.inputs.size(); ++k) {
      const std::string& name = program_.inputs[k].name;
      const std::string value = fmt::format("{}", order_.setup.program_inputs[k]);
      inputs += fmt::format("{}\"{}\": {}", k == 0 ? "" : ", ", name, value);
      const std::string place = "{{" + name + "}}";
      for (std::size_t at = 0; (at = filled.find(place, at)) != std::string::npos; at += value.size())
        filled.replace(at, place.size(), value);
    }
    write_file(folder_ / "inputs.json", inputs + "}\n");
    if (!program_.template_name.empty()) write_file(folder_ / program_.template_name, filled);
    if (!order_.checkpoint.empty()) fs::create_directories(order_.checkpoint, problem);
  }

  int let_run() {
    ProgramStart start{resolved_command(program_.command, program_.folder, program_.template_name),
                       folder_,
                       folder_ / "inputs.json",
                       folder_ / "stdout.txt",
                       folder_ / "stderr.txt",
                       {{"CAMPAIGN_STUDY_FOLDER", program_.folder},
                        {"CAMPAIGN_CHECKPOINTS", order_.checkpoint},
                        {"CAMPAIGN_THREADS", std::to_string(order_.threads)}},
                       program_.limits.most_bytes};
    if (std::getenv("OMP_NUM_THREADS") == nullptr)
      start.environment.emplace_back("OMP_NUM_THREADS", std::to_string(order_.threads));
    std::optional<ProgramProcess> process;
    try {
      process.emplace(start);
    } catch (const CannotStart& problem) {
      throw Failed{solver::Status::crashed, problem.what()};
    }
    const int status = await(*process);
    if (const int left = process->kill_all(); left > 0)
      watch_.remark(fmt::format("the program left {} process{} behind, which {} ended", left,
                                left == 1 ? "" : "es", left == 1 ? "was" : "were"));
    return status;
  }

  int await(ProgramProcess& process) {
    double looked = monotonic_seconds(), moved = looked;
    Written last;
    for (;;) {
      if (const std::optional<int> status = process.wait(0.05)) return *status;
      const double now = monotonic_seconds();
      if (watch_.told_to_end()) give_up(process, "asked to end");
      if (now > ends_)
        give_up(process, fmt::format("reached its wall-clock limit of {:g} s", order_.wall_limit_seconds));
      if (now < looked + look_interval) continue;
      looked = now;
      const Written present = written_in(folder_);
      if (present.bytes >= program_.limits.most_bytes) throw too_much();
      if (!(present == last)) moved = now;
      last = present;
      if (now > moved + program_.limits.hang_seconds)
        give_up(process, fmt::format("hung: wrote nothing for {:g} s", program_.limits.hang_seconds));
    }
  }

  [[noreturn]] void give_up(ProgramProcess& process, const std::string& reason) const {
    process.ask_to_end();
    const double until = monotonic_seconds() + after_asking;
    while (!process.wait(0.05) && monotonic_seconds() < until) continue;
    throw failed(solver::Status::time_limit, reason);
  }

  std::vector<solver::ProgramResult> results() {
    const bool named = !program_.results.empty();
    const fs::path file = folder_ / (named ? program_.results : "stdout.txt");
    std::error_code problem;
    if (!fs::is_regular_file(file, problem)) throw crashed(fmt::format("wrote no {}", program_.results));
    try {
      return read_results(read_file(file), program_.outputs);
    } catch (const BadResults& bad) {
      throw failed(bad.not_finite ? solver::Status::did_not_converge : solver::Status::crashed,
                   fmt::format("{} ({})", bad.what(), named ? program_.results : "standard output"));
    }
  }

  const Order& order_;
  const solver::ExternalProgram& program_;
  const ProgramWatch& watch_;
  fs::path folder_;
  double ends_;  // [s]
};

}  // namespace

std::vector<std::string> resolved_command(const std::vector<std::string>& command, const std::string& folder,
                                          const std::string& template_name) {
  std::vector<std::string> words = command;
  std::error_code ignored;
  for (std::string& word : words) {
    if (word.empty() || word == template_name) continue;
    if (const fs::path file = fs::path(folder) / word; fs::is_regular_file(file, ignored))
      word = file.lexically_normal().string();
  }
  return words;
}

bool is_there(const std::string& program) {
  if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

solver::Outcome run_program(const Order& order, const ProgramWatch& watch) {
  const solver::ProgramLimits& limits = order.setup.program->limits;
  const double started = monotonic_seconds();
  solver::Outcome outcome;
  for (int tries = 1;; ++tries) {
    try {
      outcome.profile.declared = Try(order, watch, started + order.wall_limit_seconds).run();
      outcome.status = solver::Status::completed;
      outcome.reason.clear();
    } catch (const Failed& failed) {
      outcome.status = failed.status;
      outcome.reason = failed.reason;
    }
    const bool again =
        outcome.status == solver::Status::crashed && tries <= limits.retries && !watch.told_to_end();
    if (!again) {
      if (outcome.status == solver::Status::crashed && tries > 1)
        outcome.reason += fmt::format(" (try {} of {})", tries, limits.retries + 1);
      break;
    }
    watch.remark(fmt::format("try {} of {}: {}; runs again", tries, limits.retries + 1, outcome.reason));
  }
  const bool told_to_end = outcome.status != solver::Status::completed && watch.told_to_end();
  if (told_to_end) {  // the same signal may have ended the program first
    outcome.status = solver::Status::time_limit;
    outcome.reason = "asked to end";
  }
  const bool failed = outcome.status != solver::Status::completed && !told_to_end;
  std::error_code ignored;
  if (!failed && !limits.keep_work) fs::remove_all(order.work, ignored);
  outcome.wall_seconds = monotonic_seconds() - started;
  return outcome;
}

solver::Outcome run_ordered_program(const Order& order) {
  outlive_parent_to_end();
  return run_program(
      order, {told_to_end, [&](std::string text) { send_remark(order.realization, std::move(text)); }});
}

}  // namespace cpt::campaign

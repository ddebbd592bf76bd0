#include "campaign/realization_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

#include "campaign/descriptors.hpp"
#include "campaign/last_words.hpp"
#include "campaign/stop_signals.hpp"

namespace cpt::campaign {
namespace {

constexpr double after_limit =
    2.0;  // [s] a realization ends itself at its limit; this much later it is asked to
constexpr double after_request = 3.0;  // [s] from asking a process to end to killing it
constexpr double after_outcome = 5.0;  // [s] for a process to exit once it has sent its outcome
constexpr std::size_t longest_last_words = 4096;
constexpr double never = std::numeric_limits<double>::infinity();

// The environment without what would make the child believe that it is a rank of the MPI job.
std::vector<char*> environment_without_mpi() {
  constexpr std::string_view prefixes[] = {"OMPI_", "PMIX_", "PMI_", "PRTE_", "ORTE_"};
  std::vector<char*> kept;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    if (std::none_of(std::begin(prefixes), std::end(prefixes), [&](auto p) { return text.starts_with(p); }))
      kept.push_back(*variable);
  }
  kept.push_back(nullptr);
  return kept;
}

// Starts the command with our channel as descriptor 3 and its output going to `errors`; returns an errno.
int spawn(pid_t& pid, const std::vector<std::string>& command, int channel, int errors) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, errors, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, channel, channel_descriptor);
  // Nothing else is inherited: not the ledger's lock, not the launcher's sockets.
  posix_spawn_file_actions_addclosefrom_np(&actions, channel_descriptor + 1);

  // A process group of its own keeps Ctrl-C away from it: its parent decides when it ends.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigset_t standard;
  sigemptyset(&none);
  sigemptyset(&standard);
  for (const int signal : stop_signals) sigaddset(&standard, signal);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&standard, signal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &standard);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);

  std::vector<char*> environment = environment_without_mpi();
  const int error =
      ::posix_spawn(&pid, arguments[0], &actions, &attributes, arguments.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

bool usable(const solver::DepthProfile& profile, const solver::ExternalProgram* program) {
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  if (program != nullptr)
    return profile.declared.size() == program->outputs.size() &&
           std::ranges::all_of(profile.declared, [&](const solver::ProgramResult& result) {
             return finite(result.x) && finite(result.y);
           });
  return !profile.depth.empty() && finite(profile.depth) &&
         std::ranges::all_of(solver::channels(),
                             [&](const solver::Channel& channel) { return finite(profile.*channel.values); });
}

void close_descriptor(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

}  // namespace

RealizationProcess::RealizationProcess(const std::vector<std::string>& command, Order order, double now)
    : order_(std::move(order)), started_(now), last_step_forward_(now) {
  std::array<int, 2> channel{-1, -1};
  std::array<int, 2> errors{-1, -1};
  int error = 0;
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel.data()) != 0 ||
      ::pipe2(errors.data(), O_CLOEXEC) != 0)
    error = errno;
  else
    error = spawn(pid_, command, channel[1], errors[1]);
  close_descriptor(channel[1]);
  close_descriptor(errors[1]);
  channel_ = channel[0];
  errors_ = errors[0];
  if (error != 0) {
    pid_ = -1;
    start_failure_ = fmt::format("cannot start {}: {}", command.front(), std::strerror(error));
    return;
  }
  ::fcntl(errors_, F_SETFL, O_NONBLOCK);
  // An order is a few kilobytes and fits the socket's buffer. If the child is gone already, its end is
  // noticed later.
  const Bytes bytes = frame(order_);
  static_cast<void>(::send(channel_, bytes.data(), bytes.size(), MSG_NOSIGNAL));
}

RealizationProcess::~RealizationProcess() {
  if (pid_ > 0) {
    kill_group();
    ::waitpid(pid_, nullptr, 0);
  }
  close_descriptor(channel_);
  close_descriptor(errors_);
}

RealizationProcess::News RealizationProcess::service(double now) {
  News news;
  if (pid_ < 0) {
    if (!start_failure_.empty()) news.outcome = failure(solver::Status::crashed, start_failure_, now);
    start_failure_.clear();
    return news;
  }
  int wait_status = 0;
  siginfo_t ended{};
  // Asked first: what it sent is then all there. While it is not reaped, its group is its own.
  const bool gone = ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                    ended.si_pid == pid_;
  if (gone) {
    kill_group();
    ::waitpid(pid_, &wait_status, 0);
  }
  read_channel(news, now);
  read_errors();
  if (gone) {
    pid_ = -1;
    close_descriptor(channel_);
    news.interrupted = interrupted(wait_status);
    news.outcome = conclude(wait_status, now);
  } else {
    enforce_limits(now);
  }
  return news;
}

void RealizationProcess::read_channel(News& news, double now) {
  std::array<std::byte, 16384> bytes;
  while (channel_ >= 0) {
    const ssize_t size = ::recv(channel_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {
      close_descriptor(channel_);
      return;
    }
    try {
      reader_.feed(std::span(bytes).first(static_cast<std::size_t>(size)));
      while (std::optional<Message> message = reader_.next()) accept(std::move(*message), news, now);
    } catch (const MalformedMessage& problem) {
      close_descriptor(channel_);
      end_by(solver::Status::crashed, fmt::format("sent an unreadable answer: {}", problem.what()), now);
    }
  }
}

void RealizationProcess::accept(Message message, News& news, double now) {
  if (auto* report = std::get_if<ProgressReport>(&message);
      report && report->realization == order_.realization) {
    if (!progress_ || report->progress.steps > progress_->steps) last_step_forward_ = now;
    progress_ = report->progress;
    news.progress = progress_;
  } else if (auto* end = std::get_if<OutcomeReport>(&message);
             end && end->realization == order_.realization) {
    if (end->outcome.status == solver::Status::completed &&
        !usable(end->outcome.profile, order_.setup.program.get()))
      throw MalformedMessage(order_.setup.program ? "a completed run without all of its finite outputs"
                                                  : "a completed run without a finite depth profile");
    outcome_ = std::move(end->outcome);
    interrupted_ = end->interrupted;
    last_step_forward_ = now;
  } else if (auto* remark = std::get_if<Remark>(&message);
             remark && remark->realization == order_.realization) {
    news.remarks.push_back(std::move(remark->text));
  } else {
    throw MalformedMessage("a message that does not belong to its order");
  }
}

void RealizationProcess::read_errors() {
  std::array<char, 4096> text;
  while (errors_ >= 0) {
    const ssize_t size = ::read(errors_, text.data(), text.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) {
      close_descriptor(errors_);
      return;
    }
    last_words_.append(text.data(), static_cast<std::size_t>(size));
    if (last_words_.size() > longest_last_words)
      last_words_.erase(0, last_words_.size() - longest_last_words);
  }
}

// With an external program that it runs, and what that has started.
void RealizationProcess::kill_group() const { ::kill(-pid_, SIGKILL); }

void RealizationProcess::ask_to_end() const {
  if (pid_ > 0) ::kill(pid_, SIGTERM);
}

void RealizationProcess::end_by(solver::Status status, std::string reason, double kill_at) {
  if (ending_) return;
  ending_ = Ending{status, std::move(reason), kill_at};
  ::kill(pid_, SIGTERM);
}

void RealizationProcess::enforce_limits(double now) {
  const std::string reached =
      progress_ ? fmt::format("at depth {:.3f} m, step {}", progress_->depth, progress_->steps)
                : "before its first step";
  if (outcome_) {
    if (now > last_step_forward_ + after_outcome) kill_group();
  } else if (now > started_ + order_.wall_limit_seconds + after_limit) {
    end_by(solver::Status::time_limit,
           fmt::format("reached its wall-clock limit of {:g} s {}", order_.wall_limit_seconds, reached),
           now + after_request);
  } else if (now > last_step_forward_ + order_.hang_limit_seconds) {
    end_by(solver::Status::time_limit,
           fmt::format("hung: no step for {:g} s {}", order_.hang_limit_seconds, reached),
           now + after_request);
  }
  if (ending_ && now >= ending_->kill_at) {
    kill_group();
    ending_->kill_at = never;
  }
}

bool RealizationProcess::interrupted(int wait_status) const {
  if (ending_) return false;
  if (outcome_) return interrupted_;
  // The signal may come before the process can catch it.
  return WIFSIGNALED(wait_status) && std::find(std::begin(stop_signals), std::end(stop_signals),
                                               WTERMSIG(wait_status)) != std::end(stop_signals);
}

solver::Outcome RealizationProcess::conclude(int wait_status, double now) {
  const std::string words = last_line(last_words_);
  const std::string said = words.empty() ? "" : fmt::format("; its last words: {}", words);
  const int signal = WIFSIGNALED(wait_status) ? WTERMSIG(wait_status) : 0;
  const int exit_code = WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 0;
  const bool lingered = outcome_ && signal == SIGKILL && now > last_step_forward_ + after_outcome;

  if (ending_) {
    // Asked to end, it may still have sent how far it came.
    if (!outcome_) return failure(ending_->status, ending_->reason, now);
    outcome_->status = ending_->status;
    outcome_->reason = ending_->reason;
    return *outcome_;
  }
  if (outcome_ && (lingered || (signal == 0 && exit_code == 0))) return *outcome_;
  const std::string_view when = outcome_ ? " after it had sent its outcome" : "";
  if (signal != 0) {
    return failure(solver::Status::crashed, fmt::format("{}{}{}", killed_by(signal), when, said), now);
  }
  if (reader_.partial())
    return failure(solver::Status::crashed,
                   fmt::format("exit code {} in the middle of its answer{}", exit_code, said), now);
  return failure(solver::Status::crashed,
                 outcome_ ? fmt::format("exit code {}{}{}", exit_code, when, said)
                          : fmt::format("exit code {} without an outcome{}", exit_code, said),
                 now);
}

solver::Outcome RealizationProcess::failure(solver::Status status, std::string reason, double now) const {
  solver::Outcome outcome;
  outcome.status = status;
  outcome.reason = std::move(reason);
  outcome.wall_seconds = now - started_;
  if (progress_) {
    outcome.steps = progress_->steps;
    outcome.material_points = progress_->material_points;
  }
  return outcome;
}

}  // namespace cpt::campaign

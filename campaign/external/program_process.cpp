#include "campaign/external/program_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <system_error>

#include "campaign/descriptors.hpp"
#include "campaign/stop_signals.hpp"

namespace cpt::campaign {
namespace {

sigset_t child_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGCHLD);
  return set;
}

bool redirect(const std::filesystem::path& file, int flags, int descriptor) {
  const int opened = ::open(file.c_str(), flags | O_CLOEXEC, 0666);
  return opened >= 0 && ::dup2(opened, descriptor) >= 0;
}

// In the new process: becomes the program, or returns.
void become(const ProgramStart& start, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) return;
  const rlimit size{static_cast<rlim_t>(start.most_bytes), static_cast<rlim_t>(start.most_bytes)}, none{0, 0};
  ::setrlimit(RLIMIT_FSIZE, &size);
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal : stop_signals) ::signal(signal, SIG_DFL);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGCHLD}) ::signal(signal, SIG_DFL);
  sigset_t all_open;
  sigemptyset(&all_open);
  ::sigprocmask(SIG_SETMASK, &all_open, nullptr);
  if (!redirect(start.input, O_RDONLY, STDIN_FILENO) ||
      !redirect(start.output, O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO) ||
      !redirect(start.errors, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO) ||
      ::chdir(start.folder.c_str()) != 0)
    return;
  ::fcntl(channel_descriptor, F_SETFD, FD_CLOEXEC);  // the words with our parent are not the program's
  for (const auto& [name, value] : start.environment) ::setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : start.command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  ::execvp(words[0], words.data());
}

// Of a process and of its threads, as the kernel lists them.
void add_children(pid_t process, std::set<pid_t>& found) {
  std::error_code gone;
  for (const auto& thread :
       std::filesystem::directory_iterator(fmt::format("/proc/{}/task", process), gone)) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child = 0; list >> child;)
      if (found.insert(child).second) add_children(child, found);
  }
}

std::set<pid_t> descendants() {
  std::set<pid_t> found;
  add_children(::getpid(), found);
  return found;
}

}  // namespace

ProgramProcess::ProgramProcess(const ProgramStart& start) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const sigset_t ended = child_signal();
  ::sigprocmask(SIG_BLOCK, &ended, nullptr);
  std::array<int, 2> failure{-1, -1};
  if (::pipe2(failure.data(), O_CLOEXEC) != 0) throw CannotStart(std::strerror(errno));
  const pid_t self = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) {
    become(start, self);
    const int problem = errno;
    static_cast<void>(::write(failure[1], &problem, sizeof problem));
    ::_exit(127);
  }
  int problem = pid_ < 0 ? errno : 0;
  ::close(failure[1]);
  while (::read(failure[0], &problem, sizeof problem) < 0 && errno == EINTR) continue;
  ::close(failure[0]);
  if (problem == 0) return;
  if (pid_ > 0) kill_all();
  throw CannotStart(fmt::format("cannot start {}: {}", start.command.front(), std::strerror(problem)));
}

ProgramProcess::~ProgramProcess() { kill_all(); }

std::optional<int> ProgramProcess::wait(double seconds) {
  for (int status = 0; pid_ > 0 && !status_;) {
    const pid_t ended = ::waitpid(-1, &status, WNOHANG);
    if (ended == pid_) status_ = status;
    if (ended > 0) continue;
    if (seconds <= 0.0) break;
    const sigset_t signals = child_signal();
    const timespec time{static_cast<time_t>(seconds), static_cast<long>(std::fmod(seconds, 1.0) * 1e9)};
    ::sigtimedwait(&signals, nullptr, &time);
    seconds = 0.0;
  }
  return status_;
}

void ProgramProcess::ask_to_end() const {
  for (const pid_t process : descendants()) ::kill(process, SIGTERM);
}

int ProgramProcess::kill_all() {
  std::set<pid_t> killed;
  static_cast<void>(wait(0.0));  // what has ended by itself does not count
  // What they start meanwhile comes to this process, too, as soon as its parent is gone.
  for (int status = 0;;) {
    for (const pid_t process : descendants())
      if (::kill(process, SIGKILL) == 0) killed.insert(process);
    const pid_t ended = ::waitpid(-1, &status, killed.empty() ? WNOHANG : 0);
    if (ended == pid_ && !status_) status_ = status;
    if (ended > 0) continue;
    if (ended < 0 && errno == EINTR) continue;
    break;  // there are no more
  }
  return static_cast<int>(killed.size());
}

}  // namespace cpt::campaign

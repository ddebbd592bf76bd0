#include "campaign/external/program_version.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "campaign/clock.hpp"
#include "campaign/external/run_program.hpp"
#include "campaign/last_words.hpp"

namespace cpt::campaign {
namespace {

constexpr double longest = 30.0;         // [s]
constexpr std::size_t most_text = 2000;  // [characters]

// Not a fork: this process may be a rank of MPI. Returns an errno.
int start(pid_t& pid, const std::vector<std::string>& command, const std::string& folder, int output) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int problem = ::posix_spawnp(&pid, words[0], &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return problem;
}

// What comes until the other end is closed; false where that takes too long or is too much.
bool read_all(int from, std::string& text) {
  std::array<char, 1024> bytes;
  for (const double until = monotonic_seconds() + longest;
       monotonic_seconds() < until && text.size() <= most_text;) {
    pollfd ready{from, POLLIN, 0};
    if (::poll(&ready, 1, 100) <= 0) continue;
    const ssize_t size = ::read(from, bytes.data(), bytes.size());
    if (size == 0) return true;
    if (size > 0) text.append(bytes.data(), static_cast<std::size_t>(size));
  }
  return false;
}

}  // namespace

std::string program_version(const std::vector<std::string>& command, const std::string& folder) {
  const std::vector<std::string> words = resolved_command(command, folder);
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw NoVersion(std::strerror(errno));
  pid_t pid = -1;
  const int problem = start(pid, words, folder, ends[1]);
  ::close(ends[1]);
  std::string text;
  const bool ended = problem == 0 && read_all(ends[0], text);
  ::close(ends[0]);
  if (problem != 0)
    throw NoVersion(fmt::format("cannot start {}: {}", words.front(), std::strerror(problem)));
  int status = 0;
  if (!ended) ::kill(-pid, SIGKILL);
  ::waitpid(pid, &status, 0);
  if (text.size() > most_text)
    throw NoVersion(fmt::format("{} prints more than {} characters", words.front(), most_text));
  if (!ended) throw NoVersion(fmt::format("{} does not end within {:g} s", words.front(), longest));
  const std::string said = text.empty() ? "" : fmt::format("; its last words: {}", last_line(text));
  if (WIFSIGNALED(status)) throw NoVersion(killed_by(WTERMSIG(status)) + said);
  if (WEXITSTATUS(status) != 0) throw NoVersion(fmt::format("exit code {}{}", WEXITSTATUS(status), said));
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw NoVersion(fmt::format("{} prints nothing", words.front()));
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

}  // namespace cpt::campaign

// An external program that this process, one realization's, has started, with all that it starts in turn.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cpt::campaign {

struct ProgramStart {
  std::vector<std::string> command;             ///< the first word a path, or looked for in PATH
  std::filesystem::path folder;                 ///< to work in
  std::filesystem::path input, output, errors;  ///< standard streams, as files
  std::vector<std::pair<std::string, std::string>> environment;  ///< beside what is inherited
  double most_bytes;                                             ///< of one file that it writes
};

/// The program is not there, or not one: `what()` names it and why.
struct CannotStart : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One at a time, in a process of one thread whose only children are the program's: what the program leaves
/// behind comes to this process (a subreaper), which ends it.
class ProgramProcess {
 public:
  /// Throws CannotStart.
  explicit ProgramProcess(const ProgramStart& start);
  /// Kills all that still runs.
  ~ProgramProcess();
  ProgramProcess(const ProgramProcess&) = delete;
  ProgramProcess& operator=(const ProgramProcess&) = delete;

  /// The program's status as waitpid gives it, once it has ended; else nothing after so many seconds, or
  /// earlier if a signal comes.
  [[nodiscard]] std::optional<int> wait(double seconds);
  /// Asks the program and what it has started to end.
  void ask_to_end() const;
  /// Kills what is left of them, and returns how many that were.
  int kill_all();

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

}  // namespace cpt::campaign

// Runs the program as a user does, for end-to-end tests.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace cpt::tests {

/// Words of a command line; the first is the program.
using Command = std::vector<std::string>;

/// `campaign` with these arguments.
[[nodiscard]] Command campaign(std::vector<std::string> arguments);
/// The same under mpirun with `ranks` ranks, with `mpi_options` for mpirun itself.
[[nodiscard]] Command mpirun(int ranks, std::vector<std::string> arguments,
                             std::vector<std::string> mpi_options = {});

struct Result {
  int exit_code = -1;  ///< 128 + signal if a signal ended it
  std::string out, err;
};

/// A program that is running. Ends with the object, if not before.
class Background {
 public:
  /// Variables are "NAME=VALUE", added to the environment.
  Background(const Command& command, const std::vector<std::string>& variables);
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] Result wait();
  /// What it has written to stderr until now.
  [[nodiscard]] std::string err_so_far() const;

 private:
  pid_t pid_ = -1;
  std::filesystem::path out_, err_;
};

[[nodiscard]] Result run(const Command& command, const std::vector<std::string>& variables = {});

/// Child processes of a process, rising.
[[nodiscard]] std::vector<pid_t> children_of(pid_t pid);

/// True while the process exists and has not ended; one that nobody has waited for has ended too.
[[nodiscard]] bool alive(pid_t pid);

/// Waits for a condition. The limit only ends a test that has failed: no machine is so slow.
[[nodiscard]] bool eventually(const std::function<bool()>& condition);

/// How many times shorter realizations are to be than they are made for, from CPT_TEST_HASTE (1): what a
/// faster machine would make of them. The stand-in divides its duration by it; real pushes are so many times
/// faster.
[[nodiscard]] double haste();
/// A study of real pushes that has a section [fixed], hurried by so much.
[[nodiscard]] std::string hurried(const std::string& study);

/// An empty folder of its own with a study of six realizations in it; removed at the end.
class StudyFolder {
 public:
  StudyFolder();
  ~StudyFolder();
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;
  [[nodiscard]] std::string study() const { return (folder_ / "small.toml").string(); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path folder_;
};

/// Everything in a database but times: realizations, curves bit for bit, windows, sensitivities.
[[nodiscard]] std::string contents(const std::string& database);

}  // namespace cpt::tests

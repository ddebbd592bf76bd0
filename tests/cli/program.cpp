#include "tests/cli/program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace cpt::tests {
namespace {

std::string read_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path temporary(const char* pattern) {
  std::string name = (std::filesystem::temp_directory_path() / pattern).string();
  const int descriptor = ::mkstemp(name.data());
  EXPECT_GE(descriptor, 0);
  ::close(descriptor);
  return name;
}

constexpr const char* small_study = R"(title = "Small"
profile = "homogeneous_sand"
preset = "quick"

[parameters]
"sand.nu" = { baseline = 0.2, lower = 0.1, upper = 0.3 }
"sand.H" = { baseline = 25, upper = 75 }
"sand.D_r_percent" = { baseline = 36, lower = 26, upper = 46 }

[[windows]]
name = "deep"
from_m = 0.5054
to_m = 0.5255
)";

}  // namespace

Command campaign(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), CAMPAIGN_PROGRAM);
  return arguments;
}

Command mpirun(int ranks, std::vector<std::string> arguments, std::vector<std::string> mpi_options) {
  Command command{MPIRUN, "--oversubscribe", "-np", std::to_string(ranks)};
  command.insert(command.end(), mpi_options.begin(), mpi_options.end());
  for (std::string& word : campaign(std::move(arguments))) command.push_back(std::move(word));
  return command;
}

Background::Background(const Command& command, const std::vector<std::string>& variables)
    : out_(temporary("campaign-out-XXXXXX")), err_(temporary("campaign-err-XXXXXX")) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::vector<std::string> own = variables;
  // As scripts/mpi-environment.
  own.insert(own.end(),
             {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "PMIX_MCA_gds=hash"});
  std::vector<char*> environment;
  for (std::string& variable : own) environment.push_back(variable.data());
  for (char** variable = environ; *variable != nullptr; ++variable) environment.push_back(*variable);
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, out_.c_str(), O_WRONLY | O_TRUNC, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, err_.c_str(), O_WRONLY | O_TRUNC, 0600);
  EXPECT_EQ(::posix_spawnp(&pid_, words[0], &actions, nullptr, words.data(), environment.data()), 0)
      << command[0];
  posix_spawn_file_actions_destroy(&actions);
}

Background::~Background() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  std::filesystem::remove(out_);
  std::filesystem::remove(err_);
}

Result Background::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_file(out_),
          read_file(err_)};
}

std::string Background::err_so_far() const { return read_file(err_); }

Result run(const Command& command, const std::vector<std::string>& variables) {
  return Background(command, variables).wait();
}

std::vector<pid_t> children_of(pid_t pid) {
  std::vector<pid_t> children;
  std::error_code gone;
  const std::filesystem::path tasks = "/proc/" + std::to_string(pid) + "/task";
  for (const auto& task : std::filesystem::directory_iterator(tasks, gone)) {
    std::ifstream list(task.path() / "children");
    children.insert(children.end(), std::istream_iterator<pid_t>(list), {});
  }
  std::sort(children.begin(), children.end());
  return children;
}

bool alive(pid_t pid) {
  const std::string status = read_file("/proc/" + std::to_string(pid) + "/stat");
  const auto end_of_name = status.rfind(')');
  return end_of_name != std::string::npos && status.at(end_of_name + 2) != 'Z';
}

bool eventually(const std::function<bool()>& condition) {
  for (int i = 0; i < 30'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

double haste() {
  const char* value = std::getenv("CPT_TEST_HASTE");
  return value != nullptr ? std::stod(value) : 1.0;
}

std::string hurried(const std::string& study) {
  if (haste() == 1.0) return study;
  const std::string heading = "[fixed]\n";
  const auto end = study.find(heading) + heading.size();
  return study.substr(0, end) + "\"penetrometer.speed_m_per_s\" = " + std::to_string(0.04 * haste()) + "\n" +
         study.substr(end);
}

StudyFolder::StudyFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "campaign-test-XXXXXX").string();
  EXPECT_NE(::mkdtemp(name.data()), nullptr);
  folder_ = name;
  write("small.toml", small_study);
}

StudyFolder::~StudyFolder() { std::filesystem::remove_all(folder_); }

void StudyFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name) << text;
}

std::string StudyFolder::read(const std::string& name) const { return read_file(folder_ / name); }

std::string contents(const std::string& database) {
  std::string all;
  constexpr const char* realizations =
      "select id, parameter, side, value, status, reason, steps, material_points, settings_hash, mass_error, "
      "momentum_error, energy_error, kinetic_fraction, max_empty_cells from realization order by id";
  const char* questions[] = {
      realizations,
      "select realization, bins, hex(depth_m), hex(q_c_Pa), hex(f_s_Pa) from curve order by realization",
      "select * from depth_window order by name", "select * from window_mean order by realization, window",
      "select * from sensitivity order by window, parameter"};
  for (const char* question : questions) {
    const Result answer = run(campaign({"query", database, "sql", question, "--format", "csv"}));
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    all += answer.out;
  }
  return all;
}

}  // namespace cpt::tests

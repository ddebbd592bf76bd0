#include "results/files/patience.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <fstream>
#include <set>
#include <sstream>
#include <utility>

namespace cpt::results {
namespace {

constexpr double patience_of_all = 10.0;  // [s]
Patience* innermost = nullptr;

// As /proc/locks names a file, "08:01:1234"; empty if there is none.
std::string lock_name(const std::string& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return {};
  return fmt::format("{:02x}:{:02x}:{}", major(about.st_dev), minor(about.st_dev), about.st_ino);
}

}  // namespace

Patience::Patience(Waiting waiting) : waiting_(std::move(waiting)), outer_(std::exchange(innermost, this)) {}

Patience::~Patience() { innermost = outer_; }

bool Patience::lasts(const std::filesystem::path& database, double seconds) {
  return innermost != nullptr ? innermost->waiting_(database, seconds) : seconds < patience_of_all;
}

std::string who_keeps(const std::filesystem::path& database) {
  // SQLite's locks are on the file itself, or on the index of its write-ahead log.
  std::set<std::string> names{lock_name(database.string()), lock_name(database.string() + "-shm")};
  names.erase("");
  std::ifstream locks("/proc/locks");
  std::string reader;  // keeps out those that write, where nobody else is in their way
  for (std::string line; std::getline(locks, line);) {
    // "1: POSIX  ADVISORY  WRITE 4711 08:01:1234 1073741824 1073742335"; "1: -> ..." is one that waits.
    std::istringstream words(line);
    std::string number, kind, advisory, access, process, file;
    words >> number >> kind >> advisory >> access >> process >> file;
    if (kind == "->" || !names.contains(file)) continue;
    if (process == std::to_string(::getpid()) || process.find_first_not_of("0123456789") != std::string::npos)
      continue;
    std::string name;
    std::ifstream command("/proc/" + process + "/comm");
    if (!std::getline(command, name)) continue;
    std::string who = fmt::format("process {} ({})", process, name);
    if (access == "WRITE") return who;
    reader = std::move(who);
  }
  return reader.empty() ? "another program" : reader;
}

}  // namespace cpt::results

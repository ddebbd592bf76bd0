#include "campaign/mpirun_output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>

namespace cpt::campaign {
namespace {

constexpr std::array<std::string_view, 4> launchers = {"mpirun", "mpiexec", "orterun", "prterun"};

bool is_pipe_without_reader(const std::string& link) {
  const int descriptor = ::open(link.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) return errno == ENXIO;
  ::close(descriptor);
  return false;
}

}  // namespace

std::string lost_by_mpirun() {
  const std::string parent = fmt::format("/proc/{}", ::getppid());
  std::string name;
  std::getline(std::ifstream(parent + "/comm"), name);
  if (std::ranges::find(launchers, name) == launchers.end()) return "";

  const std::string link = parent + "/fd/1";
  struct stat itself {
  }, target{};
  if (::lstat(link.c_str(), &itself) != 0) return errno == ENOENT ? "it is closed" : "";
  // Closed at the start, the number was taken by a descriptor of mpirun's that may be for reading alone.
  if ((itself.st_mode & S_IWUSR) == 0) return "it is closed";
  if (::stat(link.c_str(), &target) != 0) return "";
  if (S_ISFIFO(target.st_mode)) return is_pipe_without_reader(link) ? "its reader has gone" : "";
  const dev_t full = makedev(1, 7);  // /dev/full
  struct statvfs room {};
  if ((S_ISCHR(target.st_mode) && target.st_rdev == full) ||
      (S_ISREG(target.st_mode) && ::statvfs(link.c_str(), &room) == 0 && room.f_bavail == 0))
    return "No space left on device";
  return "";
}

}  // namespace cpt::campaign

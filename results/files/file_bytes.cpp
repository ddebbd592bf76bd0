#include "results/files/file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace cpt::results {
namespace {

// Waits until a pipe or terminal has more. Not again after a signal: it may ask for just that.
bool more_to_come(int descriptor) {
  pollfd waiting{descriptor, POLLIN, 0};
  return ::poll(&waiting, 1, -1) > 0;
}

// 0 or an errno.
int read_all(int descriptor, std::string& bytes, std::size_t most) {
  std::array<char, 65536> part;
  while (bytes.size() <= most) {
    const ssize_t size = ::read(descriptor, part.data(), part.size());
    if (size > 0)
      bytes.append(part.data(), static_cast<std::size_t>(size));
    else if (size == 0)
      return 0;
    else if (errno == EAGAIN ? !more_to_come(descriptor) : errno != EINTR)
      return errno;
  }
  return EFBIG;
}

}  // namespace

std::string_view not_a_file(const std::filesystem::path& file) {
  std::error_code ignored;
  switch (std::filesystem::status(file, ignored).type()) {
    case std::filesystem::file_type::directory:
      return "is a folder";
    case std::filesystem::file_type::fifo:
      return "is a pipe";
    case std::filesystem::file_type::socket:
      return "is a socket";
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character:
      return "is a device";
    default:
      return "";
  }
}

// A stream would throw at a folder, and names no cause; and to open a pipe waits for a writer if it may.
std::optional<std::string> bytes_of(const std::filesystem::path& file, std::error_code& why,
                                    std::size_t most) {
  why.clear();
  std::string bytes;
  int descriptor = -1;
  do descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  while (descriptor < 0 && errno == EINTR);
  int problem = descriptor < 0 ? errno : read_all(descriptor, bytes, most);
  struct stat opened {};
  if (problem == 0 && bytes.empty() && ::fstat(descriptor, &opened) == 0 && S_ISFIFO(opened.st_mode))
    problem = EPIPE;
  if (descriptor >= 0) ::close(descriptor);
  if (problem == 0) return bytes;
  why.assign(problem, std::generic_category());
  return std::nullopt;
}

std::string cause_of(const std::filesystem::path& file, const std::error_code& why, std::size_t most) {
  if (why == std::errc::file_too_large) return fmt::format("more than {} MiB", most >> 20U);
  if (why == std::errc::broken_pipe) return "is a pipe to which nobody writes";
  if (why == std::errc::no_such_device_or_address && not_a_file(file) == "is a socket") return "is a socket";
  return why.message();
}

}  // namespace cpt::results

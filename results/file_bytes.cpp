#include "results/file_bytes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace cpt::results {

// A stream would throw at a folder, and names no cause.
std::optional<std::string> bytes_of(const std::filesystem::path& file, std::error_code& why,
                                    std::size_t most) {
  why.clear();
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  std::string bytes;
  std::array<char, 65536> part;
  ssize_t size = descriptor < 0 ? -1 : 1;
  while (size > 0 && bytes.size() <= most) {
    size = ::read(descriptor, part.data(), part.size());
    if (size < 0 && errno == EINTR)
      size = 1;
    else if (size > 0)
      bytes.append(part.data(), static_cast<std::size_t>(size));
  }
  if (bytes.size() > most) why = std::make_error_code(std::errc::file_too_large);
  if (size < 0) why.assign(errno, std::generic_category());
  if (descriptor >= 0) ::close(descriptor);
  return why ? std::nullopt : std::optional(std::move(bytes));
}

}  // namespace cpt::results

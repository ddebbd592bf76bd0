#include "results/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace cpt::results {
namespace {

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// A rename is on disk once its folder is. Some network file systems cannot sync folders; they need not.
void sync_folder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) (void)::fsync(opened.number());
}

[[noreturn]] void give_up(const std::string& temporary, const std::filesystem::path& file) {
  const int why = errno;
  ::unlink(temporary.c_str());
  throw Error(fmt::format("{}: cannot be written ({})", file.string(), std::strerror(why)));
}

}  // namespace

void write_atomically(const std::filesystem::path& file, std::string_view start, std::string_view rest) {
  const std::string temporary = file.string() + ".tmp";
  bool written = false;
  {
    const Descriptor opened(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    written = opened.number() >= 0 && write_all(opened.number(), start) && write_all(opened.number(), rest) &&
              ::fsync(opened.number()) == 0;
  }
  if (!written) give_up(temporary, file);
  move_into_place(temporary, file);
}

void move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& file) {
  if (std::rename(temporary.c_str(), file.c_str()) != 0) give_up(temporary, file);
  sync_folder(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace cpt::results

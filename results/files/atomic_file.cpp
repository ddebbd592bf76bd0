#include "results/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "results/files/file_lock.hpp"
#include "results/files/file_system.hpp"
#include "results/files/refusal.hpp"

namespace cpt::results {
namespace {

namespace fs = std::filesystem;

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
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
void sync_folder(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) (void)::fsync(opened.number());
}

/// Leaves errno as it is.
[[noreturn]] void give_up(const fs::path& file) { throw Error(refusal(file, "cannot be written", errno)); }

[[noreturn]] void give_up(const fs::path& temporary, const fs::path& file) {
  const int why = errno;
  ::unlink(temporary.c_str());
  errno = why;
  give_up(file);
}

/// FILE.tmp; where that would be too long a name, with less of it.
fs::path temporary_of(const fs::path& file) {
  constexpr std::size_t longest_name = 255;  // [bytes]
  constexpr std::string_view ending = ".tmp";
  return file.parent_path() / file.filename().string().substr(0, longest_name - ending.size()).append(ending);
}

/// Opens it empty, once no other program writes it; where the file system knows no locks, without waiting.
Descriptor open_temporary(const fs::path& temporary) {
  for (;;) {
    Descriptor opened(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
    if (opened.number() < 0) return opened;
    while (::flock(opened.number(), LOCK_EX) != 0 && errno == EINTR) {
    }
    if (!still_named(opened.number(), temporary)) continue;  // the other one has moved it into place
    return ::ftruncate(opened.number(), 0) == 0 ? std::move(opened) : Descriptor(-1);
  }
}

void write_file(const fs::path& name, std::string_view start, std::string_view rest, bool to_disk) {
  std::error_code error;
  fs::path file = name;
  if (fs::is_symlink(name, error))
    if (const fs::path target = fs::canonical(name, error); !error) file = target;
  const fs::file_status there = fs::status(file, error);
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));  // fails for a folder
    if (opened.number() < 0 || !write_all(opened.number(), start) || !write_all(opened.number(), rest))
      give_up(name);
    return;
  }
  const fs::path temporary = temporary_of(file);
  const Descriptor opened = open_temporary(temporary);
  if (opened.number() < 0) give_up(name);
  // A network tells only then whether there was room.
  const bool sync = to_disk || file_system_of(file) == FileSystem::network;
  if (!write_all(opened.number(), start) || !write_all(opened.number(), rest) ||
      (sync && ::fsync(opened.number()) != 0) || ::rename(temporary.c_str(), file.c_str()) != 0)
    give_up(temporary, name);
  if (to_disk) sync_folder(file.has_parent_path() ? file.parent_path() : ".");
}

}  // namespace

void write_atomically(const fs::path& file, std::string_view start, std::string_view rest) {
  write_file(file, start, rest, true);
}

void replace_file(const fs::path& file, std::string_view text) { write_file(file, text, "", false); }

void move_into_place(const fs::path& temporary, const fs::path& file) {
  if (std::rename(temporary.c_str(), file.c_str()) != 0) give_up(temporary, file);
  sync_folder(file.has_parent_path() ? file.parent_path() : ".");
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error) && !error)
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) throw Error(refusal(folder, "cannot be made", error));
}

}  // namespace cpt::results

#include "results/files/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "results/files/error.hpp"
#include "results/files/refusal.hpp"

namespace cpt::results {
std::string holder_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  return std::getline(in, line) && !line.empty() ? line : "another process";
}

bool still_named(int descriptor, const std::filesystem::path& file) {
  struct stat held {};
  struct stat named {};
  return fstat(descriptor, &held) == 0 && stat(file.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
         held.st_dev == named.st_dev;
}

FileLock::FileLock(std::filesystem::path file) : file_(std::move(file)) {
  while (true) {
    // Close-on-exec: a realization's own process must not inherit, and outlive us with, the lock.
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw Error(refusal(file_, "cannot be created", errno));
    // A reader that asks is_held() has it for a moment.
    int why = flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    for (int again = 0; again < 5 && why == EWOULDBLOCK; ++again) {
      usleep(10000);
      why = flock(descriptor_, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
    }
    if (why != 0) {
      close(descriptor_);
      if (why == EWOULDBLOCK)
        throw Locked(fmt::format("{}: held by {}; wait until that campaign ends, or end it", file_.string(),
                                 holder_of(file_)));
      throw Error(refusal(file_, "cannot be locked", why));
    }
    if (still_named(descriptor_, file_)) break;
    close(descriptor_);
  }
  const std::string text = fmt::format("process {}\n", getpid());
  // The text only helps a message; the lock holds without it.
  if (ftruncate(descriptor_, 0) == 0) (void)!::write(descriptor_, text.data(), text.size());
}

FileLock::~FileLock() {
  unlink(file_.c_str());  // while still locked, so nobody else can hold this name yet
  close(descriptor_);
}

bool is_held(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return errno != ENOENT;
  const bool held = flock(descriptor, LOCK_SH | LOCK_NB) != 0;
  close(descriptor);
  return held;
}

}  // namespace cpt::results

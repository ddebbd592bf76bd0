// An advisory lock file, so that one campaign at a time writes a database.
#pragma once

#include <filesystem>
#include <string>

namespace cpt::results {

/// Holds `file` locked while it lives. The kernel drops the lock with the process, however it ends, so a
/// leftover file never blocks. Works on local disks and on network file systems that support flock.
class FileLock {
 public:
  /// Throws Locked, naming the holder, if another process (or object) holds it; Error if the file cannot be
  /// made.
  explicit FileLock(std::filesystem::path file);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

/// Whether an open file still has its name. Between open and flock the former holder may have removed it, or
/// moved it elsewhere, and the name be another's.
[[nodiscard]] bool still_named(int descriptor, const std::filesystem::path& file);

/// Whether a FileLock holds the file now, here or elsewhere. Leaves nothing behind; for readers, to whom a
/// file that cannot be looked at counts as held.
[[nodiscard]] bool is_held(const std::filesystem::path& file);

/// "process 1234", or "another process" where the file does not say: who holds it, if somebody does.
[[nodiscard]] std::string holder_of(const std::filesystem::path& file);

}  // namespace cpt::results

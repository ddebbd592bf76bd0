// Removing finished results that a study no longer asks for: nothing else does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "results/files/database.hpp"
#include "results/files/file_lock.hpp"

namespace cpt::results {

/// A row of `unused`, and how its study was otherwise than the one that is stored.
struct UnusedRun {
  std::int64_t id = 0;
  std::string parameter, side, value_text, status, settings_hash, solver_version, finished;
  std::int64_t study = 0;  ///< of `former_study`
};

/// In the order of their ids; none where the schema is older than they are.
[[nodiscard]] std::vector<UnusedRun> unused_runs(const Database& database);

/// What a former study's baseline had otherwise than the stored one's: "sand.H = 20 (now 25)", in
/// alphabetical order. Empty where only rows, points or windows differ.
[[nodiscard]] std::vector<std::string> former_settings(const Database& database, std::int64_t study);

/// Holds the lock of a ledger, so that no campaign goes on meanwhile.
class Pruning {
 public:
  /// Throws Locked if a campaign holds it; Error as read_snapshot.
  explicit Pruning(const std::filesystem::path& database);
  [[nodiscard]] const Database& database() const { return database_; }
  /// In one transaction.
  void remove(std::span<const UnusedRun> runs);
  /// Gives the room of what was removed back to the file system; returns the bytes.
  std::int64_t shrink();

 private:
  FileLock lock_;
  Database database_;
};

}  // namespace cpt::results

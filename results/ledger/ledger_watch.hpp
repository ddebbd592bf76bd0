// Notices that a campaign has got further.
#pragma once

#include <cstdint>
#include <filesystem>

#include "results/files/database.hpp"

namespace cpt::results {

/// Tells when another process has changed a ledger.
class LedgerWatch {
 public:
  /// Throws as read_snapshot.
  explicit LedgerWatch(const std::filesystem::path& database);
  /// True if something was committed, or a campaign began or ended to run, since the last call; and at the
  /// first.
  [[nodiscard]] bool changed();

 private:
  Database database_;
  std::filesystem::path lock_;
  std::int64_t version_ = -1;
  bool held_ = false;
};

}  // namespace cpt::results

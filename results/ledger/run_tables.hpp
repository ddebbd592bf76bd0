// Where a ledger holds runs. Used in this folder alone.
#pragma once

#include <optional>
#include <string_view>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// Names of the tables.
struct RunTables {
  const char *run, *curve, *checksum;
};
inline constexpr RunTables in_use_tables{"realization", "curve", "checksum"};  ///< what the study asks for
/// Finished runs whose settings the study no longer has, or that another solver version made.
inline constexpr RunTables unused_tables{"unused", "unused_curve", "unused_checksum"};

/// A run with its curve; nothing if there is no such id.
[[nodiscard]] std::optional<StoredRun> read_run(const Database& database, int id, const RunTables& tables);

}  // namespace cpt::results

// What is still whole in a damaged ledger.
#pragma once

#include <filesystem>
#include <vector>

#include "results/snapshot.hpp"

namespace cpt::results {

/// Completed realizations of a damaged ledger that match their checksums, with ids up to `largest_id`.
/// Whatever cannot be read is left out; throws nothing for it. None of a ledger of imported results.
[[nodiscard]] std::vector<StoredRun> salvage_runs(const std::filesystem::path& damaged, int largest_id);

/// Renames a database, and what SQLite keeps beside it, to NAME.damaged (an earlier one is replaced); returns
/// that name. Throws Error if it cannot.
std::filesystem::path set_aside(const std::filesystem::path& database);

}  // namespace cpt::results

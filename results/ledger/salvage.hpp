// What is still whole in a damaged ledger.
#pragma once

#include <filesystem>
#include <vector>

#include "results/ledger/snapshot.hpp"

namespace cpt::results {

struct Salvage {
  std::vector<StoredRun> runs;  ///< finished ones that match their checksums; unused ones last
  CampaignRow study;            ///< that they belonged to; empty where it cannot be read
};

/// Whatever cannot be read of a damaged ledger is left out; throws nothing for it. None of a ledger of
/// imported results. Where it does not tell its largest id, those up to the one given are tried.
[[nodiscard]] Salvage salvage(const std::filesystem::path& damaged, int largest_id_unless_told);

/// Renames a database, and what SQLite keeps beside it, to NAME.damaged (an earlier one is replaced); returns
/// that name. Throws Error if it cannot.
std::filesystem::path set_aside(const std::filesystem::path& database);

}  // namespace cpt::results

// Finished runs that no realization of the study has the settings of any more: an edit sets them aside,
// another one takes them back. Each is a write within a transaction of the caller. Used in this folder alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/ledger/ledger_rows.hpp"
#include "results/ledger/salvage.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// Puts a run of another ledger, times included, in place of a pending realization of the same settings.
void replace_run(const Database& database, int id, const StoredRun& run);
/// Puts what a damaged ledger held, and no realization of this one has the settings of, among the unused
/// runs; returns how many.
int keep_salvaged(const Database& database, const Salvage& salvaged);
/// Completed runs of another ledger, unused ones too; none of imported results. Throws as read_snapshot.
[[nodiscard]] std::vector<StoredRun> completed_runs(const std::filesystem::path& other);
/// Moves all realizations with negative ids to the unused runs.
void keep_unused(const Database& database);
/// Drops the former studies that no unused run belongs to.
void forget_former_studies(const Database& database);
/// Moves an unused run to the realizations.
void use_again(const Database& database, std::int64_t unused_id, int id, const RealizationInput& input);

}  // namespace cpt::results

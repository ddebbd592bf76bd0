// The STUDY|DB argument of the commands that read results.
#pragma once

#include <filesystem>

#include "results/ledger/ledger_view.hpp"

namespace cpt::cli {

/// The ledger of a study (NAME.toml) as its file says now, or a database as it is stored. What sets the two
/// apart is said on stderr, unless `quiet`.
[[nodiscard]] results::LedgerView open_ledger(const std::filesystem::path& study_or_database,
                                              bool quiet = false);

}  // namespace cpt::cli

// Everything that the program does with a ledger that it was given.
#pragma once

#include <filesystem>
#include <string>

#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

/// Bytes of a sound ledger: quick_study() with its realizations completed, failed and pending, curves of a
/// few bins.
[[nodiscard]] const std::string& sound_ledger();

/// A path of this process's own in memory or the temporary folder; nothing is there.
[[nodiscard]] std::filesystem::path scratch(const std::string& name);

/// Reads, queries, reports and salvages the ledger, then resumes its campaign and mirrors its curves; all of
/// it works or throws results::Error. Sound if all of it works.
[[nodiscard]] Fate use_ledger(const std::filesystem::path& database);

}  // namespace cpt::fuzz

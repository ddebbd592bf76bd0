// What several effects at once explain, in SQLite: tables effect, effect_parameter, subset, effect_group and
// several of the diagnosis' database.
#pragma once

#include <filesystem>

#include "diagnosis/assemble.hpp"
#include "diagnosis/several/findings.hpp"

namespace cpt::diagnosis {

/// Replaces what the file holds of earlier findings, in one transaction; `assembled` is what they are
/// about. Throws results::Error.
void store_findings(const std::filesystem::path& database, const Findings& findings,
                    const Assembled& assembled);

/// "surface_compaction + gain_drift + something else", "nothing".
[[nodiscard]] std::string subset_name(const Subset& subset, const Problem& problem);

}  // namespace cpt::diagnosis

// Campaigns with the studies of Yost et al. (2023), Tables 2 and 3, and made-up curves of their shape, driven
// through the ledger as a campaign does.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "parameters/study.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::reports {

/// Realizations that do not complete: what happens to them by id; "pending" leaves them waiting.
using Mishaps = std::map<int, std::string>;

/// 21 realizations of the homogeneous sand; one fixed window.
[[nodiscard]] parameters::Study sand_study(const std::filesystem::path& folder);
/// 12 realizations of the homogeneous clay.
[[nodiscard]] parameters::Study clay_study(const std::filesystem::path& folder);
/// Layered sand and clay with a peak and a trough window.
[[nodiscard]] parameters::Study layered_study(const std::filesystem::path& folder);

/// Repeats of the baseline, whose made-up averages scatter by little.
void add_repeats(parameters::Study& study, int count);

/// Runs the study with made-up outcomes and reads it back. A mishap is a solver status name.
[[nodiscard]] results::Snapshot run_made_up(const parameters::Study& study, const Mishaps& mishaps = {});

/// A study of sand with four rows and this text under [design], run with made-up outcomes that depend on the
/// inputs together; every tenth run fails.
[[nodiscard]] results::Snapshot run_made_up_design(const std::filesystem::path& file,
                                                   const std::string& design);

}  // namespace cpt::reports

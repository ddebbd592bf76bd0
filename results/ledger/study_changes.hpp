// What has been edited in a study since its database was written last, for the user to see.
#pragma once

#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "results/files/database.hpp"

namespace cpt::results {

/// One sentence a difference: inputs of the baseline ("sand.H: 25, was 20"), bounds and windows, in
/// alphabetical order. Empty for a new database and an unchanged study.
[[nodiscard]] std::vector<std::string> study_changes(const Database& database,
                                                     const parameters::Study& study);

}  // namespace cpt::results

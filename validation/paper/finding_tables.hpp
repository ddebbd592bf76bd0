// The findings as Markdown: one table a group, and below it why something differs or is not there.
#pragma once

#include <string>
#include <vector>

#include "validation/paper/causes.hpp"
#include "validation/paper/pushes.hpp"

namespace cpt::validation::paper {

/// How many checks hold, then the groups. Each row that differs has its cause, if one is known, with what
/// the databases say of it.
[[nodiscard]] std::string finding_tables(const Runs& runs, const std::vector<Cause>& causes,
                                         const Runs* beside);

}  // namespace cpt::validation::paper

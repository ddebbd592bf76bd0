// When a propagation that ends by itself has enough runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

/// The least number of runs, of those at which the rule is looked at (parameters/designs/propagation.hpp),
/// all of which have ended and with which the study's rule holds for every window that lies somewhere. A
/// property of these runs alone: it depends neither on their order nor on what else has run. nullopt: not
/// yet, or the design has no rule.
[[nodiscard]] std::optional<std::size_t> runs_that_suffice(const parameters::Study& study,
                                                           const Snapshot& snapshot, Runs runs);

/// Ids of the design's own points that its first `enough` runs do without.
[[nodiscard]] std::vector<int> ids_beyond(const parameters::Study& study, std::size_t enough);

/// "the 95 % quantile is known to +- 3 % in every window after 110 runs, 890 are not needed"; while it is
/// not: "... is not yet known ...". Empty without a rule.
[[nodiscard]] std::string stop_words(const parameters::Study& study, std::optional<std::size_t> enough);

}  // namespace cpt::results

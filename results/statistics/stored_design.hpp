// The design of a study as its ledger has it: read from the study's text, with the stored run of each of its
// places.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

struct StoredDesign {
  std::optional<parameters::Study> study;  ///< none: see `problem`
  std::vector<const RealizationRow*>
      runs;                           ///< in the design's order; nullptr where the ledger has another one
  std::optional<std::size_t> enough;  ///< runs that suffice by the design's rule; `runs` are then these
  std::string stopped;                ///< what the rule says, in a sentence; empty without one
  std::string problem;                ///< why the study's text cannot be read
};

/// Points into the snapshot. No runs for a ledger that holds none of the design's, such as a diagnosis'.
[[nodiscard]] StoredDesign stored_design(const Snapshot& snapshot);

}  // namespace cpt::results

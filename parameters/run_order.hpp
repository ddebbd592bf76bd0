// In which order a campaign's realizations are best run, so that a report says something early.
#pragma once

#include <span>
#include <vector>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// What to expect of a row before anything has run: about the size of its sensitivity index. A guess from
/// Yost et al. (2023): indices for their bounds, scaled to the row's. It decides about order alone, never
/// about a result.
[[nodiscard]] double expected_effect(const Row& row);

struct RunOrder {
  std::vector<int> ids;  ///< of all realizations
  int leading = 0;       ///< the first so many are the baseline and the rows that a first report shows
};

/// The baseline, then the rows from the largest expected effect to the smallest with both bounds of a row
/// together, then points and repeats in the order given. The first four rows lead.
[[nodiscard]] RunOrder run_order(const Study& study, std::span<const Realization> realizations);

}  // namespace cpt::parameters

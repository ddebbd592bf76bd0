// What a study runs: the baseline, each row at its lower and at its upper bound, and the points of its
// design.
#pragma once

#include <span>
#include <vector>

#include "parameters/realization.hpp"
#include "parameters/study.hpp"

namespace cpt::parameters {

/// The baseline first (id 1), then rows in file order, lower before upper, then the study's points. A bound
/// equal to the baseline has no realization of its own.
[[nodiscard]] std::vector<Realization> all_realizations(const Study& study);

/// Id of the realization that holds one side of a row; the baseline's where the bound equals the baseline.
[[nodiscard]] int realization_of(std::span<const Realization> realizations, int row, Side side);

/// What differs anywhere in the study: its rows, then what its points change, each once.
[[nodiscard]] std::vector<const solver::Quantity*> varied_quantities(const Study& study);

}  // namespace cpt::parameters

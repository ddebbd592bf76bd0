// Where a simulated curve begins to tell of the soil.
#pragma once

#include <cstddef>

#include "solver/simulate.hpp"

namespace cpt::results {

/// Leading bins that hold the start of a push that began with full speed (numerics.start_distance_m = 0, and
/// solvers before 0.6): the blow that takes the soil around the cone's face along falls into the first bin,
/// of which the tip passes a part only. They are the bins before q_c first rises, if it falls by a fifth or
/// more, and within 2 mm; 0 where it rises from the first. What is stored keeps them: plots draw them apart,
/// and windows that hold one say so.
[[nodiscard]] std::size_t bins_of_start(const solver::DepthProfile& profile);

}  // namespace cpt::results

// Mechanisms of the reading: what instrument and depth datum make of a push, which itself stays as it is.
#pragma once

#include "solver/setup.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {

/// The profile of a push as it would be recorded: with what of the sleeve's force reaches the tip's load
/// cell, the drift of that cell's gain, the offset and drift of its zero, and depths along rods that leave
/// the vertical, from the shifted datum. As it is where all are off. Sources: sleeve_load.hpp,
/// gain_drift.hpp, zero_offset.hpp, zero_drift.hpp, inclination.hpp, depth_datum.hpp.
[[nodiscard]] DepthProfile as_recorded(DepthProfile profile, const Setup& setup);

}  // namespace cpt::solver

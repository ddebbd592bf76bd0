// How the numbers of a propagation settle as runs come in.
#pragma once

#include <vector>

#include "results/statistics/propagation_rows.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

/// After 10, 20, ... runs, at most forty numbers of runs and the last of them all; as far as all of the first
/// runs have ended.
void add_convergence(const WindowEffects& window, std::vector<ConvergenceRow>& rows);

}  // namespace cpt::results

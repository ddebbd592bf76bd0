// The realization's own process: receives one order, runs it, sends progress and the outcome, ends.
#pragma once

#include <functional>

#include "solver/simulate.hpp"

namespace cpt::campaign {

using Simulate =
    std::function<solver::Outcome(const solver::Setup&, solver::Observer&, const solver::Execution&)>;

/// Serves the parent at descriptor 3 and returns the process's exit code. The process dies with its parent;
/// the stop signals ask `simulate` to stop, and what it has so far is still sent. The order's checkpoint, if
/// it is whole and of the same settings, is where `simulate` goes on; a new one is written at the order's
/// intervals and before stopping. One that cannot be used or written is remarked on, no more.
[[nodiscard]] int serve_realization(const Simulate& simulate);

}  // namespace cpt::campaign

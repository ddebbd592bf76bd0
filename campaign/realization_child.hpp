// The realization's own process: receives one order, runs it, sends progress and the outcome, ends.
#pragma once

#include <functional>

#include "solver/simulate.hpp"

namespace cpt::campaign {

using Simulate =
    std::function<solver::Outcome(const solver::Setup&, solver::Observer&, const solver::Execution&)>;

/// Serves the parent at descriptor 3 and returns the process's exit code. The process dies with its parent;
/// SIGTERM asks `simulate` to stop, and what it has so far is still sent.
[[nodiscard]] int serve_realization(const Simulate& simulate);

}  // namespace cpt::campaign

// The cores this machine lets the campaign use.
#pragma once

namespace cpt::campaign {

/// Frees this process, and the realizations it will start, from the binding to a core or two that mpirun
/// gives its ranks by default: they may use every core that was mpirun's own. Without mpirun nothing changes,
/// so that taskset and batch systems are obeyed. Returns the number of cores then allowed, at least 1, also
/// bounded by the CPU quota of the control group (containers).
int use_allowed_cores(bool started_by_launcher);

/// Share of one of `ranks` ranks in `cores`; the shares add up to `cores`. `rank` counts from 0.
[[nodiscard]] constexpr int share_of_cores(int cores, int ranks, int rank) {
  return cores / ranks + (rank < cores % ranks ? 1 : 0);
}

}  // namespace cpt::campaign

// Two campaigns side by side: what was set, what came out.
#pragma once

#include "results/ledger/snapshot.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// Every input of the baselines, and every bound, that is not the same in both: `setting`, `a`, `b` (empty
/// where one has none).
[[nodiscard]] Table compare_settings(const Snapshot& a, const Snapshot& b);

/// Averages of q_c of realizations that change the same input to the same value, by window: `window`,
/// `parameter`, `side`, `value`, `a_kPa`, `b_kPa`, `change` = b / a - 1, `note`: who lacks it, or that the
/// windows lie apart.
[[nodiscard]] Table compare_means(const Snapshot& a, const Snapshot& b);

/// Sensitivity indices: `window`, `parameter`, and of each `si`, the half width of its interval from repeats,
/// whether it is above the noise (of the repeats, without them SI_noise) and SI_noise; `note`: who lacks it,
/// or the notes of both.
[[nodiscard]] Table compare_sensitivity(const Snapshot& a, const Snapshot& b);

/// "no window of a is one of b: a has ...; b has ..."; empty where they share one by name, or one has none.
[[nodiscard]] std::string windows_apart(const Snapshot& a, const Snapshot& b);

}  // namespace cpt::results

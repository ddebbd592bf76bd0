// What a dear study's windows are worth with the runs of a cheaper one beside its own few: the same
// propagation at two presets (parameters/designs/multifidelity.hpp).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// One of the studies.
struct FidelityLevel {
  std::string name, preset;
  int runs = 0;              ///< of the design that ended with a result
  double seconds_a_run = 0;  ///< wall-clock time, mean of its completed runs
};

/// A number of a window's average, in the window's unit, from the dear runs alone and from both.
struct FidelityRow {
  std::string window, unit, quantity;  ///< mean, standard_deviation, quantile_05 ...
  parameters::Estimate alone, combined;
};

/// How the two go along with each other in a window.
struct FidelityWindow {
  std::string window;
  int paired = 0;            ///< runs that both have
  double correlation = 0.0;  // [-]
  double variance_ratio =
      0.0;  ///< [-] of a mean for equal time, runs shared out best, over the dear runs alone
  double best_run_ratio = 0.0;  ///< [-] cheap runs for each dear one at which it is reached
  /// Of the emulator of the cheap runs: Q2 and correlation with the dear ones, at runs it was made without.
  /// NaN if none was asked for or the runs do not tell its inputs apart.
  double emulator_q2 = std::numeric_limits<double>::quiet_NaN();
  double emulator_correlation = std::numeric_limits<double>::quiet_NaN();
};

struct TwoFidelities {
  FidelityLevel dear, cheap;
  std::vector<FidelityWindow> windows;
  std::vector<FidelityRow> rows;
  /// Inputs whose index has another sign in the other study while both exceed their noise, in sentences.
  std::vector<std::string> warnings;
  int emulated_runs = 0;  ///< of the third level; 0: there is none
};

/// Throws Error where the two are no pair: another design than a propagation, other rows, or a run whose
/// inputs differ; it says which. With `emulated_runs` an emulator of the cheap runs is a third level with so
/// many runs (emulated_level.hpp), in every window where its Q2 is at least 0.9; a warning says where not.
[[nodiscard]] TwoFidelities two_fidelities(const Snapshot& dear, const Snapshot& cheap,
                                           int emulated_runs = 0);

[[nodiscard]] Table fidelity_table(const TwoFidelities& both);

}  // namespace cpt::results

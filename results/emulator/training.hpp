// What an emulator learns from: the runs of a study in its ledger that vary inputs together.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "parameters/study.hpp"
#include "results/emulator/emulator.hpp"
#include "results/ledger/snapshot.hpp"

namespace cpt::results {

/// An output of the training runs.
struct TrainingOutput : OutputLabel {
  Eigen::VectorXd abscissa;  ///< of a curve; empty of an average
  Eigen::MatrixXd values;    ///< [its unit] values x runs
};

struct TrainingRuns {
  std::string study, solver_version, windows;
  std::vector<EmulatorInput> inputs;
  std::vector<TrainedRun> runs;
  Eigen::MatrixXd places;  ///< runs x inputs, in the unit cube
  std::vector<TrainingOutput> outputs;
  std::vector<std::string> notes;  ///< what was left out and why, in sentences
};

/// Inputs are the rows of the study's [design], of a study without one those that its points change. Runs are
/// the completed ones that leave everything else at the baseline, within the inputs' ranges: the baseline,
/// bounds of the inputs, the design's and the study's own points; repeats are not, as held-out runs would
/// have twins. A range is the row's bounds, of a row with a distribution its 0.05 % to 99.95 % quantiles and
/// whatever runs lie beyond; it is logarithmic where the median is nearer to the middle in ln(value).
/// Outputs are the averages of q_c and f_s over each window and their curves, at the baseline's depths as far
/// down as every run came; of an external program the results of the windows and the declared curves, alike.
/// Throws Error where there are no such inputs, fewer runs than
/// least_training_runs, or no output.
[[nodiscard]] TrainingRuns training_runs(const parameters::Study& study, const Snapshot& campaign);

/// Three for each input and ten: enough for a linear trend in every fold of the validation.
[[nodiscard]] Eigen::Index least_training_runs(std::size_t inputs);

/// Fits every output and validates it (cross_validation). An output that does not vary is left out, with a
/// note. Several seconds for 300 runs of eight inputs.
[[nodiscard]] Emulator make_emulator(const TrainingRuns& runs, std::vector<std::string>& notes);

/// How an emulator differs from what the ledger now holds, in sentences: other inputs or bounds, windows,
/// solver version, runs that are no longer there and runs that are new. Empty if it does not.
[[nodiscard]] std::vector<std::string> stale(const Emulator& emulator, const TrainingRuns& now);

}  // namespace cpt::results

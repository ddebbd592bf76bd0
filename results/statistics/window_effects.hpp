// The rows of one window that the estimator of a design adds, each from its file in designs/.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/study.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/statistics/effects.hpp"

namespace cpt::results {

using Runs = std::span<const RealizationRow* const>;

/// "2 of 44 runs failed, 1 still to run"; empty if all are completed. A run that the design asks for twice is
/// one.
[[nodiscard]] std::string missing_runs(Runs runs);
/// "2 of 44 runs out of line"; empty if none is.
[[nodiscard]] std::string runs_out_of_line(Runs runs);

/// What an estimator gets of a window, and where its rows go.
struct WindowEffects {
  /// `runs` are those of the design, in its order; nullptr where the ledger has another one.
  WindowEffects(const parameters::Study& study, const Snapshot& snapshot, const WindowRow& window, Runs runs,
                std::vector<EffectRow>& rows);

  const parameters::Study& study;
  const Snapshot& snapshot;
  const WindowRow& window;
  Runs runs;
  std::vector<EffectRow>& rows;
  Eigen::VectorXd y;      // [the window's unit, kPa of q_c] average of each run; NaN where there is none
  bool constant = false;  ///< the result does not vary
  std::string remarks;    ///< runs that are missing or out of line
  std::string note;       ///< of every row: these, and that an index of a constant result is undefined
  std::string method;     ///< of the rows that follow

  void prepend(std::string_view words);
  void append(std::string_view words);
  /// Name of the parameter of that place in the design.
  [[nodiscard]] std::string name(std::size_t parameter) const;
  void put(std::size_t parameter, std::string_view quantity, std::string_view unit,
           const parameters::Estimate& estimate, int used, int dropped, int with_results);
  /// How good the polynomial is that the numbers come from: its Q2, its size in the note.
  void put_fit(double q2, int degree, int terms, int used, int dropped);
  /// One quantity of all parameters.
  void put_all(std::string_view quantity, const std::vector<parameters::Estimate>& estimates, int used,
               int dropped, int with_results);
};

}  // namespace cpt::results

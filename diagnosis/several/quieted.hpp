// Runs of the solver with less of their scatter: what a run shares of the baseline's own scatter, because it
// has the same seed, mesh and time steps, is known from the baseline's repeats and taken off.
#pragma once

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// A control variate (Owen 2013, Monte Carlo theory, methods and examples, section 8.9) for curves.
class Quieted {
 public:
  /// `repeats` (n x k) [ln]: the baseline with other seeds, meshes and time steps. Fewer than three leave all
  /// curves as they are.
  Quieted(const std::vector<Cell>& cells, const VectorXd& baseline, const MatrixXd& repeats);

  /// Mean of the baseline and its repeats (n).
  [[nodiscard]] const VectorXd& baseline() const { return mean_; }
  /// Of the scatter of one run, what the mean still has: its variance over theirs.
  [[nodiscard]] double share() const { return share_; }
  /// The run (n) less the share rho, from 0 to 1 in each curve, of the baseline's scatter: rho that of their
  /// second differences over depth, where the scatter shows and what the run is about hardly does.
  [[nodiscard]] VectorXd operator()(const VectorXd& run) const;

 private:
  [[nodiscard]] VectorXd differences(const VectorXd& curve, Index top, Index bottom) const;

  std::vector<std::pair<Index, Index>> curves_;  ///< top and end of each
  VectorXd mean_, control_;                      // n; the baseline less the mean
  double share_ = 1.0;
};

}  // namespace cpt::diagnosis

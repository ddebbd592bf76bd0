// Where recording and simulation part: depth intervals on which a step of ln q_c is missing.
//
// The statistic of an interval with indicator h is the likelihood ratio of a step fitted by generalized least
// squares, (h^T M^-1 r)^2 / (h^T M^-1 h). M contains what the parameters can do, so that every scan refits
// them. The greatest statistic over all intervals is compared with its distribution over curves drawn from
// the null model: the chance of any false interval in a sounding is alpha (Westfall and Young 1993).
#pragma once

#include <cstdint>

#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// Rows [first, end).
struct RowRange {
  Index first, end;
};

/// A step fitted on an interval.
struct Step {
  std::vector<RowRange> rows;  ///< one range, or one for each sounding
  double size = 0.0;           // [ln q_c]
  double statistic = 0.0;      // [-]
};

/// All intervals of all soundings, and where there are several soundings also the same depths in all of them
/// with one step.
class StepScan {
 public:
  /// `cells` as in a depth grid; the same rows as `covariance`. Intervals have `least_cells` or more.
  StepScan(const std::vector<Cell>& cells, const Whitener& covariance, int least_cells);

  /// The interval with the greatest statistic that shares no row with those `taken`; size 0 if there is none.
  /// `weighted` is M^-1 r.
  [[nodiscard]] Step best(const VectorXd& weighted, const std::vector<RowRange>& taken = {}) const;

  /// The greatest statistic for each column of M^-1 r.
  [[nodiscard]] VectorXd greatest(const MatrixXd& weighted) const;

 private:
  void add(const std::vector<RowRange>& ranges, const MatrixXd& sums);

  std::vector<RowRange> ranges_;
  std::vector<std::size_t> first_;   // of each interval in ranges_, and one past the last
  std::vector<double> information_;  // h^T M^-1 h
};

struct LocateOptions {
  double alpha = 0.05;     ///< family-wise error, in (0, 1)
  int least_cells = 2;     ///< of an interval
  int most_intervals = 8;  ///< reported
};

/// An interval on which the recording departs from what the null model can give.
struct Mismatch {
  int sounding;      ///< -1: the same depths in all soundings
  double from, to;   // [m]
  double size;       // [ln q_c] step missing beside moving parameters; departure.hpp has what figures show
  double percent;    // [%] the same, of q_c
  double step;       // [Pa] the same, in q_c: mean over the interval of the simulated curve times percent
  double statistic;  // [-]
  double p;          // [-] family-wise
};

struct Location {
  double threshold;                  ///< (1 - alpha) quantile of the greatest statistic under the null
  double greatest;                   ///< the recording's
  double p;                          ///< of that; 1 / (draws + 1) at the least
  std::vector<Mismatch> mismatches;  ///< the most significant first; they do not overlap
};

/// `residual` (n) = recorded - null mean; `null_draws` (n x draws) the same of null curves (draw_null, 1000
/// or more); `covariance` is M; `simulated` (n) [ln q_c] is the curve that sizes in Pa refer to. Reported are
/// intervals with p <= alpha, greedily: the step is taken off and the rest scanned again.
[[nodiscard]] Location locate(const std::vector<Cell>& cells, const VectorXd& residual,
                              const Whitener& covariance, const MatrixXd& null_draws,
                              const VectorXd& simulated, const LocateOptions& options = {});

/// (1 + how many of `draws` reach `value`) / (1 + draws).
[[nodiscard]] double bootstrap_p(double value, const VectorXd& draws);

}  // namespace cpt::diagnosis

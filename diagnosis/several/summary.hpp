// What a posterior over subsets says: the effects' curve and that of something else over depth, the soil's,
// and each effect's parameters.
#pragma once

#include "diagnosis/several/subsets.hpp"

namespace cpt::diagnosis {

/// A curve over the cells and its standard deviation [ln].
struct Band {
  VectorXd mean, deviation;  // n
};

/// An effect where it is present.
struct EffectSummary {
  double inclusion;       ///< probability that it is
  VectorXd place;         // dimensions, posterior mean in the unit cube, within it
  VectorXd deviation;     // dimensions
  VectorXd lower, upper;  // dimensions, 5 and 95 % quantiles
  VectorXd curve;         // n [ln] posterior mean of what it does
};

struct Summary {
  Band effects;         ///< what all effects and something else do together, averaged over all subsets
  Band something_else;  ///< of that, what no effect of the catalogue does
  VectorXd soil;        // n [ln] what the study's parameters do, averaged alike
  VectorXd normals;     // p: posterior mean of the first p columns' standard normals, averaged alike
  MatrixXd covariance;  // p x p: theirs
  std::vector<EffectSummary> each;  ///< in the problem's order
};

/// `residual` (n) as in explain, `parameters` (n x k) those of the Scatter that the metrics are made of; the
/// normals of the first `soil` of them are summarized.
[[nodiscard]] Summary summarize(const SubsetWeigher& weigher, const Explained& explained,
                                const VectorXd& residual, const MatrixXd& parameters, Index soil = 0);

/// The same of one subset alone.
[[nodiscard]] Summary summarize(const SubsetWeigher& weigher, const WeighedSubset& subset,
                                const VectorXd& residual, const MatrixXd& parameters, Index soil = 0);

/// Two-sided: 2 min(F, 1 - F), F that of chi-square for the recording's distance from the subset, its nodes
/// and metrics averaged. A distance that is too small is a scatter that was taken for too large.
struct TwoSidedCheck {
  double chi_square;  // [-] e^T (C + U U^T)^-1 e
  double freedom;     // [-] cells
  double p;
};
[[nodiscard]] TwoSidedCheck check_subset(const SubsetWeigher& weigher, const WeighedSubset& subset,
                                         const VectorXd& residual);

}  // namespace cpt::diagnosis

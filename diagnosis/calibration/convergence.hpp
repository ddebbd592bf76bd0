// Whether chains of a sampler have come to the same distribution, and how many independent draws they are
// worth: rank-normalized split R-hat, bulk and tail effective sizes (Vehtari, Gelman, Simpson, Carpenter &
// Bürkner 2021, Bayesian Analysis 16, 667-718).
#pragma once

#include <Eigen/Dense>

namespace cpt::diagnosis {

struct Convergence {
  double r_hat = 0.0;  ///< the larger one of the ranks' and of their distances' from the median; 1 at best
  double bulk_size = 0.0;  ///< effective draws, of all chains, for the middle of the distribution
  double tail_size = 0.0;  ///< the same for its 5 and 95 % quantiles, the smaller one
  [[nodiscard]] double least_size() const { return bulk_size < tail_size ? bulk_size : tail_size; }
};

/// Of one quantity, `draws` steps x chains. All NaN where it never changes or a chain has fewer than 8 steps.
[[nodiscard]] Convergence convergence(const Eigen::MatrixXd& draws);

/// Effective number of all draws (steps x chains) for their mean: autocorrelations within and between chains
/// (eq. 10), cut off by Geyer's (1992) initial monotone sequence. Without splitting and ranks.
[[nodiscard]] double effective_size(const Eigen::MatrixXd& draws);

/// Ratio of the total to the mean variance within chains (eq. 1-4), square root; without splitting and ranks.
[[nodiscard]] double potential_scale_reduction(const Eigen::MatrixXd& draws);

}  // namespace cpt::diagnosis

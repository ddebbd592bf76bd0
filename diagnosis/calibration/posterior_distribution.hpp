// The distribution of a study's row that is nearest to draws of a posterior.
#pragma once

#include <Eigen/Dense>

#include "parameters/distributions/distribution.hpp"

namespace cpt::diagnosis {

struct FittedDistribution {
  parameters::Family family = parameters::Family::normal;
  double mean = 0.0, deviation = 0.0;   ///< of the draws, and of the distribution before it is cut off
  double least = 0.0, most = 1.0;       ///< cut off there; of a beta distribution its ends
  std::vector<double> values, weights;  ///< of a discrete one
  /// Largest distance of its 5, 25, 50, 75 and 95 % quantiles from the draws', over their standard deviation.
  double apart = 0.0;
};

/// Of normal, lognormal and beta with the draws' mean and standard deviation the one with the quantiles
/// nearest to the draws'; discrete, with the share of each value, where `discrete`. `draws` lie in [least,
/// most].
[[nodiscard]] FittedDistribution fitted_distribution(const Eigen::VectorXd& draws, double least, double most,
                                                     bool discrete);

/// Spearman's correlations to two digits that a Gaussian copula can have: the nearest where those found are
/// none.
[[nodiscard]] Eigen::MatrixXd copula_rank_correlations(const Eigen::MatrixXd& found);

}  // namespace cpt::diagnosis

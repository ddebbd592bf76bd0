// How much of a result's variance each input accounts for where inputs depend on each other: Shapley effects
// (Owen 2014, SIAM/ASA J. Uncertainty Quantification 2, 245-251; Song, Nelson & Staum 2016, ibid. 4,
// 1060-1083), which add up to one whatever the dependence, and the first-order and total indices of
// Kucherenko, Tarantola & Annoni (2012, Computer Physics Communications 183, 937-946).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "parameters/designs/bootstrap.hpp"

namespace cpt::parameters {

/// An input as it is distributed.
struct ScoredInput {
  int values = 0;                       ///< that it takes, equally spaced; 0: all of the unit interval
  std::function<double(double)> place;  ///< where in the unit interval the value of a normal score lies
};

struct ShapleyIndices {
  std::vector<Estimate> shapley;  ///< shares of the variance, 1 in all
  std::vector<Estimate>
      first;  ///< what knowing the input takes off the variance, with what goes along with it
  std::vector<Estimate> total;  ///< what is left where all others are known
  double q2;                    ///< 1 - cross-validated squared error of the expansion over the variance of y
  int degree = 0, terms = 0;    ///< of the expansion
  int used = 0;                 ///< runs
  int dropped = 0;              ///< runs without a result
  std::string problem;          ///< why there are none, or why they are not to be believed; or empty
};

inline constexpr int most_shapley_inputs = 12;

/// Of a sparse expansion of y (sparse_expansion.hpp), NaN where there is no result, over `places` (runs x
/// inputs, in the unit interval). Of every subset u of the inputs the share of Var E(Y | X_u) is the
/// correlation of the expansion at points and at others that have X_u in common and the rest drawn anew,
/// given X_u: conditional normal scores, by a Gaussian copula with this correlation. At least a thousand
/// points, randomized Sobol' points of this seed; scores are cut off at 3.3 to either side, one in a
/// thousand.
///
/// Intervals: delete-a-group jackknife (Kott 2001) over ten folds of the runs, each with its own expansion,
/// and of the points at the same time, so that they hold the error of both. Q2 is that of the folds.
[[nodiscard]] ShapleyIndices shapley_indices(const Eigen::MatrixXd& places, const Eigen::VectorXd& y,
                                             const std::vector<ScoredInput>& inputs,
                                             const Eigen::MatrixXd& correlation, std::uint64_t seed);

/// Shapley effects from the value of each subset (bit j: input j), of which that of all inputs is 1 and of
/// none 0.
[[nodiscard]] Eigen::VectorXd shapley_effects(int inputs, const Eigen::VectorXd& value_of_subset);

}  // namespace cpt::parameters

// Numbers of a dear model from few of its runs and many of cheaper ones that go along with it: multifidelity
// Monte Carlo (Peherstorfer, Willcox & Gunzburger 2016, SIAM J. Sci. Comput. 38, A3163), with the runs of
// propagations (designs/propagation.hpp), whose first runs are the same whatever their number.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parameters/designs/bootstrap.hpp"

namespace cpt::parameters {

/// Results of one model's runs 1, 2, ... of the design; NaN where a run has none. The dearest first; each
/// cheaper one has at least as many runs.
using Levels = std::vector<Eigen::VectorXd>;

/// Runs that all models have a result of, which the weights are found from.
[[nodiscard]] Eigen::Index paired_runs(const Levels& levels);

/// Pearson's correlation of a cheaper model's results with the dearest one's over the paired runs.
[[nodiscard]] double level_correlation(const Levels& levels, std::size_t cheaper);

/// A number with its 95 % interval by the jackknife over sections (jackknife_half_width). NaN
/// with fewer than ten paired runs, no interval with sections that have none. The interval of a quantile lies
/// between the values whose shares of the runs are the probability less and plus that of its share (Woodruff
/// 1952, Journal of the American Statistical Association 47, 635), since the jackknife fails for quantiles
/// themselves.
///
/// mean:       y_0 + sum_l a_l (mean of y_l over all its runs - over those of the model before it),
///             a_l = cov(y_0, y_l) / var(y_l), of the paired runs.
/// deviation:  the same of the squares about the mean of each model, then the root.
/// quantile:   the same of the indicators of y <= x, after a straight line through the paired runs has
///             brought each cheaper model to the dearest one's scale; the least x at which this is at
///             least the probability.
[[nodiscard]] Estimate combined_mean(const Levels& levels, bool latin = false);
[[nodiscard]] Estimate combined_deviation(const Levels& levels, bool latin = false);
[[nodiscard]] Estimate combined_quantile(const Levels& levels, double probability, bool latin = false);

/// The least variance of a mean for a unit of cost with two models over that of the dear one alone, if the
/// runs are shared out best: (sqrt(1 - rho^2) + sqrt(rho^2 w))^2, w the cost of a cheap run over that of a
/// dear one (their section 3.2).
[[nodiscard]] double variance_ratio(double correlation, double cost_ratio);
/// Cheap runs for each dear one at which it is reached: sqrt(rho^2 / (w (1 - rho^2))), at least 1.
[[nodiscard]] double best_run_ratio(double correlation, double cost_ratio);

}  // namespace cpt::parameters

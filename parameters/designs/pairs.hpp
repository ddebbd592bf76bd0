// Full 2^2 factorial of every pair of parameters at their bounds, the others at their baselines: which pairs
// act together?
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// The pairs of `parameters` in order: (0, 1), (0, 2), ..., (1, 2), ...
[[nodiscard]] std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs_of(int parameters);

/// Four runs a pair x parameters, in the unit cube: both lower, the first upper, the second upper, both
/// upper. NaN: left at its baseline.
[[nodiscard]] Eigen::MatrixXd pairs_places(int parameters);

/// ((y_both - y_second) - (y_first - y_neither)) / 2: half of what the second parameter changes in the first
/// one's effect (Box, Hunter & Hunter 2005, Statistics for Experimenters, chapter 5). `y` holds the four
/// runs as pairs_places orders them; NaN where one of them is missing, 0 within rounding (variation.hpp).
[[nodiscard]] double interaction(const std::array<double, 4>& y);

/// The interaction with its interval: each of the four runs scatters independently by the same share of its
/// size, so that half of their sum scatters by half of their norm times that share. `scatter` is t s / mean
/// of repeats of one run, t Student's 97.5 % point with their n - 1 degrees of freedom; NaN: no interval.
[[nodiscard]] Estimate interaction_estimate(const std::array<double, 4>& y, double scatter);

[[nodiscard]] DesignKind pairs_design();

}  // namespace cpt::parameters

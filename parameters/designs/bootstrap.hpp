// Bootstrap intervals of what a design estimates.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace cpt::parameters {

/// A number with its 95 % interval; NaN where there is none.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();
  double upper = std::numeric_limits<double>::quiet_NaN();
};

/// Draws that an interval is made from where they are cheap.
inline constexpr int bootstrap_draws = 2000;

/// Units (trajectories, rows, runs) that a sample consists of; one may come several times.
using Resample = std::vector<Eigen::Index>;

/// The estimator's numbers for all units, each with its interval: the estimator is called again for samples
/// of as many units drawn with replacement, and the interval lies between two percentiles of what it gives,
/// the expanded ones of Hesterberg (2015), "What teachers should know about the bootstrap", The American
/// Statistician 69, 371-386: with n units, Phi(-/+ t sqrt(n / (n - 1))), t the 97.5 % point of
/// Student's distribution with n - 1 degrees of freedom. The plain 2.5 and 97.5 % are too narrow for few
/// units. Draws that are not finite do not count; no interval for fewer than three units or where more than
/// a tenth of the draws is not finite. The same seed gives the same intervals.
[[nodiscard]] std::vector<Estimate> bootstrap(
    Eigen::Index units, int samples, std::uint64_t seed,
    const std::function<Eigen::VectorXd(const Resample&)>& estimator);

}  // namespace cpt::parameters

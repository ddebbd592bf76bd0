// Do results differ, or only in their last digits? An index of results that do not vary is a quotient of
// roundings; every estimator asks here first.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string_view>

namespace cpt::parameters {

/// [-] of the largest size: numbers that lie no further apart are equal but for rounding. Double precision
/// rounds at 2e-16; sums over bins, decimal texts and other programs leave 1e-12; no result is known to nine
/// digits.
inline constexpr double rounding_share = 1e-9;

inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// What a note says of an index of such results.
inline constexpr std::string_view does_not_vary = "undefined: the result does not vary";

/// Whether two numbers differ by more than rounding; false where one is NaN.
[[nodiscard]] bool differ(double a, double b);

/// Whether some of the numbers differ by more than rounding. NaN, a run without a result, does not count.
[[nodiscard]] bool varies(const Eigen::VectorXd& numbers);

/// Two or more numbers that do not vary. One alone, or none, tells nothing.
[[nodiscard]] bool is_constant(const Eigen::VectorXd& numbers);

}  // namespace cpt::parameters

// How far repeats of one run scatter that differ in nothing physical, and what that says of a sensitivity
// index. It sees all noise between runs; window_noise.hpp sees that of one run along its depth.
#pragma once

#include <optional>
#include <span>

namespace cpt::results {

/// Repeats of one number.
struct RepeatNoise {
  int runs;          // [-] >= 3
  double mean;       // in the numbers' unit
  double deviation;  // standard deviation of one run, with n - 1 degrees of freedom
};

/// nullopt with fewer than three numbers.
[[nodiscard]] std::optional<RepeatNoise> repeat_noise(std::span<const double> numbers);

/// Half width of the interval about the mean that holds one more run with a probability of 95 %, in the
/// numbers' unit: t s sqrt(1 + 1/n) (prediction interval, Student's t with n - 1 degrees of freedom).
[[nodiscard]] double prediction_half_width(const RepeatNoise& noise);

/// Half width [-] of the 95 % interval of SI = (q_upper - q_lower) / q_upper where both averages scatter as
/// the repeats do and are nearly equal: sqrt(2) t s / mean. A smaller |SI| may be chance. Wants mean > 0.
[[nodiscard]] double index_half_width(const RepeatNoise& noise);

}  // namespace cpt::results

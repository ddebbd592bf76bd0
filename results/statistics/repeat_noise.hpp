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
  double deviation;  // standard deviation of one run, with n - 1 degrees of freedom; 0 within rounding
};

/// Student's t: 97.5 % of its distribution with so many degrees of freedom lie below.
[[nodiscard]] double student_t(double freedom);

/// nullopt with fewer than three numbers.
[[nodiscard]] std::optional<RepeatNoise> repeat_noise(std::span<const double> numbers);

/// Half width of the interval about the mean that holds one more run with a probability of 95 %, in the
/// numbers' unit: t s sqrt(1 + 1/n) (prediction interval, Student's t with n - 1 degrees of freedom).
[[nodiscard]] double prediction_half_width(const RepeatNoise& noise);

/// Half width [-] of the 95 % interval of SI = (q_upper - q_lower) / q_upper = 1 - q_lower / q_upper, to
/// first order (delta method): both averages are single runs that scatter by the same share of their size,
/// that of the repeats, independently of each other, so that SI deviates by sqrt(2) s / mean |q_lower /
/// q_upper|; t times that. A smaller |SI| may be chance. Wants mean > 0. The ledger's view `sensitivity`
/// computes the same in SQL.
[[nodiscard]] double index_half_width(const RepeatNoise& noise, double q_lower, double q_upper);

/// The same from pairs: the index of a row again with both of its runs' material points shifted alike, each
/// time by another amount. t s of these indices; it needs no assumption on how far the two runs of an index
/// scatter and on how far they do so together. NaN with fewer than three.
[[nodiscard]] double paired_half_width(std::span<const double> indices);

/// The same where the averages are equal, the smallest |SI| that is told from chance: sqrt(2) t s / mean.
[[nodiscard]] double index_half_width(const RepeatNoise& noise);

}  // namespace cpt::results

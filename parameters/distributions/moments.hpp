// Parameters of a family from what is known of an input: its mean and standard deviation, or two quantiles.
// Pure functions; std::nullopt where no such member exists.
#pragma once

#include <array>
#include <optional>

#include "parameters/distributions/distribution.hpp"

namespace cpt::parameters {

/// Of normal, lognormal and uniform, from the mean and a standard deviation above 0. Lognormal: a mean above
/// 0 (Johnson, Kotz & Balakrishnan 1994, ch. 14).
[[nodiscard]] std::optional<Distribution> from_moments(Family family, double mean, double deviation);

/// A value that is not exceeded with a probability between 0 and 1.
struct Quantile {
  double probability, value;
};
/// Of normal, lognormal and uniform, through two quantiles in ascending order of both.
[[nodiscard]] std::optional<Distribution> from_quantiles(Family family, const std::array<Quantile, 2>& two);

/// Beta between `least` and `most` with that mean and standard deviation, which must be less than that of two
/// values at the ends (Johnson, Kotz & Balakrishnan 1995, ch. 25).
[[nodiscard]] std::optional<Distribution> beta_from_moments(double least, double most, double mean,
                                                            double deviation);
/// That largest standard deviation.
[[nodiscard]] double most_deviation(double least, double most, double mean);

}  // namespace cpt::parameters

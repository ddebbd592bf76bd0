// Intervals from independent sections of a sample.
#pragma once

#include <span>

#include "parameters/designs/bootstrap.hpp"

namespace cpt::parameters {

/// Sections that an interval rests on, at least.
inline constexpr int least_sections = 5;

/// `value`, the number of a whole sample, +- t s / sqrt(k): `own` are the same number of its k sections, s
/// their deviation from `value` and t Student's 97.5 % point with k - 1 degrees of freedom (Nakayama 2014,
/// Winter Simulation Conference, section 4). The sections are independent samples that are each spread
/// evenly, which formulas for independent runs and the bootstrap know nothing of. NaN among `own` do not
/// count; no interval from fewer than five.
[[nodiscard]] Estimate sectioned(double value, std::span<const double> own);

}  // namespace cpt::parameters

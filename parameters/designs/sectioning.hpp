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

/// Half the width of a 95 % interval by the jackknife over sections: t s sqrt(k - 1), `left_out` the same
/// number with each of the k sections in turn left out, s^2 the mean square of their deviations from their
/// mean and t Student's 97.5 % point with k - 1 degrees of freedom (Kott 2001, Journal of Official Statistics
/// 17, 521). For a number that a single section is too small for. NaN if any of them is.
[[nodiscard]] double jackknife_half_width(std::span<const double> left_out);
/// `value` with that interval, or with none.
[[nodiscard]] Estimate jackknifed(double value, const Eigen::RowVectorXd& left_out);

}  // namespace cpt::parameters

// A curve between its bins.
#pragma once

#include <vector>

namespace cpt::results {

/// Linear between the two bins about the depth; NaN beyond the curve, and of a curve without values. `depths`
/// [m] rise, with a value each.
[[nodiscard]] double value_at_depth(const std::vector<double>& depths, const std::vector<double>& values,
                                    double depth);

}  // namespace cpt::results

// Full 2^k factorial: all corners of the box that the rows' bounds make (Box, Hunter & Hunter 2005,
// Statistics for Experimenters, chapter 5).
#pragma once

#include <Eigen/Core>

#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// 2^parameters runs x parameters; the first parameter changes from run to run.
[[nodiscard]] Eigen::MatrixXd factorial_places(int parameters);

/// Mean of the results at a parameter's upper bound less that at its lower one; NaN where a run is missing.
[[nodiscard]] double main_effect(const Eigen::MatrixXd& places, const Eigen::VectorXd& y,
                                 Eigen::Index parameter);

[[nodiscard]] DesignKind factorial_design();

}  // namespace cpt::parameters

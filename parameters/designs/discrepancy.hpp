// How evenly a sample fills the box: the centred L2 discrepancy (Hickernell 1998, "A generalized discrepancy
// and quadrature error bound", Mathematics of Computation 67, 299-322). It takes all sub-boxes from each
// corner, those of single parameters too; 0 would be perfectly even.
#pragma once

#include <Eigen/Core>

namespace cpt::parameters {

/// Of places in the unit cube, runs x parameters.
[[nodiscard]] double centred_discrepancy(const Eigen::MatrixXd& places);

/// What another place adds to the square of it, but for a term that is the same for all places: of several,
/// the one with the least leaves the most even sample.
[[nodiscard]] double added_discrepancy(const Eigen::Ref<const Eigen::MatrixXd>& places,
                                       const Eigen::RowVectorXd& place);

}  // namespace cpt::parameters

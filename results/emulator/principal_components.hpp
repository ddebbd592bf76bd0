// Principal components of curves (Jolliffe 2002, Principal Component Analysis, section 3.5): a curve is the
// mean curve and a few shapes, each times a score. A number is a curve of one value.
#pragma once

#include <Eigen/Dense>

namespace cpt::results {

struct PrincipalComponents {
  Eigen::VectorXd mean;      ///< values of a curve
  Eigen::MatrixXd shapes;    ///< values x components, orthonormal
  Eigen::VectorXd left_out;  ///< variance of the curves about mean and shapes, at each value
};

/// Of `curves` (values x runs): as many components as leave at most `variance_left` of the curves' variance
/// over, `most` of them at most. None of curves that do not vary. Of a shape the value that is largest by
/// amount is positive.
[[nodiscard]] PrincipalComponents principal_components(const Eigen::MatrixXd& curves, double variance_left,
                                                       Eigen::Index most);

/// components x runs
[[nodiscard]] Eigen::MatrixXd scores(const PrincipalComponents& components, const Eigen::MatrixXd& curves);

}  // namespace cpt::results

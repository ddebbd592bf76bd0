// Principal components of curves (Jolliffe 2002, Principal Component Analysis, section 3.5): a curve is the
// mean curve and a few shapes, each times a score. A number is a curve of one value.
#pragma once

#include <Eigen/Dense>

namespace cpt::results {

struct PrincipalComponents {
  Eigen::VectorXd mean;      ///< values of a curve
  Eigen::MatrixXd shapes;    ///< values x components, orthonormal
  Eigen::VectorXd left_out;  ///< variance of the curves about mean and shapes, at each value
  /// Correlation of what is left out between values so many places apart, from one at none: a mean over runs
  /// and values, of a stationary process where values are at equal distances.
  Eigen::VectorXd left_out_correlation;
};

/// Of `curves` (values x runs): as many components as leave at most `variance_left` of the curves' variance
/// over, `most` of them at most. None of curves that do not vary. Of a shape the value that is largest by
/// amount is positive.
[[nodiscard]] PrincipalComponents principal_components(const Eigen::MatrixXd& curves, double variance_left,
                                                       Eigen::Index most);

/// Covariance of what is left out, values x values.
[[nodiscard]] Eigen::MatrixXd left_out_covariance(const PrincipalComponents& components);

/// components x runs
[[nodiscard]] Eigen::MatrixXd scores(const PrincipalComponents& components, const Eigen::MatrixXd& curves);

}  // namespace cpt::results

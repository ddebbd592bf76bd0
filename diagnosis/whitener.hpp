// A covariance by its Cholesky factor L: whitening, colouring and the normal density.
#pragma once

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// C = L L^T. If C is not numerically positive definite, 1e-12, 1e-11, ... 1e-6 of its mean variance is added
/// to its diagonal until it is; past that the constructor throws std::invalid_argument.
class Whitener {
 public:
  explicit Whitener(const MatrixXd& covariance);

  [[nodiscard]] Index size() const { return lower_.rows(); }
  /// L^-1 x, column by column.
  [[nodiscard]] MatrixXd whiten(const MatrixXd& x) const;
  /// L z, column by column.
  [[nodiscard]] MatrixXd colour(const MatrixXd& z) const;
  /// C^-1 x, column by column.
  [[nodiscard]] MatrixXd solve(const MatrixXd& x) const;
  [[nodiscard]] double log_determinant() const { return log_determinant_; }
  /// ln N(residual; 0, C).
  [[nodiscard]] double log_density(const VectorXd& residual) const;

 private:
  MatrixXd lower_;
  double log_determinant_ = 0.0;
};

}  // namespace cpt::diagnosis

#include "diagnosis/whitener.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cpt::diagnosis {

Whitener::Whitener(const MatrixXd& covariance) {
  const double variance = covariance.trace() / static_cast<double>(covariance.rows());
  for (double jitter = 0.0; jitter < 2e-6; jitter = jitter == 0.0 ? 1e-12 : 10.0 * jitter) {
    MatrixXd mended = covariance;
    mended.diagonal().array() += jitter * variance;
    const Eigen::LLT<MatrixXd> factor(mended);
    if (factor.info() != Eigen::Success) continue;
    lower_ = factor.matrixL();
    log_determinant_ = 2.0 * lower_.diagonal().array().log().sum();
    if (std::isfinite(log_determinant_)) return;
  }
  throw std::invalid_argument("a covariance is not positive definite");
}

MatrixXd Whitener::whiten(const MatrixXd& x) const { return lower_.triangularView<Eigen::Lower>().solve(x); }

MatrixXd Whitener::colour(const MatrixXd& z) const { return lower_.triangularView<Eigen::Lower>() * z; }

MatrixXd Whitener::solve(const MatrixXd& x) const {
  return lower_.triangularView<Eigen::Lower>().transpose().solve(whiten(x));
}

double Whitener::log_density(const VectorXd& residual) const {
  const auto n = static_cast<double>(size());
  return -0.5 * (n * std::log(2.0 * std::numbers::pi) + log_determinant_ + whiten(residual).squaredNorm());
}

}  // namespace cpt::diagnosis

#include "diagnosis/unknown.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/covariance.hpp"
#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

double at(double from, double to, int i, int count) {
  return count > 1 ? from * std::pow(to / from, static_cast<double>(i) / (count - 1)) : from;
}

// Orthonormal basis, whitened by M, of what the parameters can do above the noise.
MatrixXd parameters_span(const NullModel& null, const Whitener& M) {
  const MatrixXd factors = null.parameters.prior_factors();
  if (factors.cols() == 0) return MatrixXd(null.mean.size(), 0);
  const Eigen::JacobiSVD<MatrixXd> svd(Whitener(null.sigma).whiten(factors), Eigen::ComputeThinV);
  Index strong = 0;
  while (strong < svd.singularValues().size() && svd.singularValues()(strong) > 1.0) ++strong;
  if (strong == 0) return MatrixXd(null.mean.size(), 0);
  const MatrixXd span = M.whiten(factors * svd.matrixV().leftCols(strong));
  const Eigen::HouseholderQR<MatrixXd> qr(span);
  return qr.householderQ() * MatrixXd::Identity(span.rows(), strong);
}

}  // namespace

double unknown_evidence(const std::vector<Cell>& cells, const NullModel& null, const VectorXd& residual,
                        const UnknownOptions& options) {
  const Whitener M(null.covariance);
  const VectorXd r = M.whiten(residual);
  const MatrixXd U = parameters_span(null, M);
  double top = cells.front().depth, bottom = top;
  for (const Cell& cell : cells) {
    top = std::min(top, cell.depth);
    bottom = std::max(bottom, cell.depth);
  }
  const double shortest = options.least_length * cells.front().height;
  const double longest = std::max(options.most_length * (bottom - top), 1.5 * shortest);
  const double constant =
      static_cast<double>(r.size()) * std::log(2.0 * std::numbers::pi) + M.log_determinant();

  VectorXd log_density(options.lengths * options.amplitudes);
  Index entry = 0;
  for (int l = 0; l < options.lengths; ++l) {
    const MatrixXd kernel =
        noise_covariance(cells, {Kernel::matern_32, 1.0, at(shortest, longest, l, options.lengths)});
    MatrixXd K = M.whiten(M.whiten(kernel).transpose());
    K -= U * (U.transpose() * K).eval();
    K -= ((K * U).eval() * U.transpose()).eval();
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (K + K.transpose()));
    const Eigen::ArrayXd power = eigen.eigenvalues().array().max(0.0);
    const Eigen::ArrayXd rotated = (eigen.eigenvectors().transpose() * r).array();
    for (int a = 0; a < options.amplitudes; ++a) {
      const double amplitude = at(options.least_amplitude, options.most_amplitude, a, options.amplitudes);
      const Eigen::ArrayXd variance = 1.0 + amplitude * amplitude * power;
      log_density(entry++) = -0.5 * (constant + variance.log().sum() + (rotated.square() / variance).sum());
    }
  }
  return log_sum_exp(log_density) - std::log(static_cast<double>(log_density.size()));
}

}  // namespace cpt::diagnosis

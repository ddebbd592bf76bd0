#include "diagnosis/several/metric.hpp"

#include <cmath>

#include "diagnosis/covariance.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {
namespace {

// Orthonormal columns, whitened by M, of what the parameters can do above the noise.
MatrixXd strong_span(const MatrixXd& parameters, const Whitener& sigma, const Whitener& M) {
  if (parameters.cols() == 0) return MatrixXd(parameters.rows(), 0);
  const Eigen::JacobiSVD<MatrixXd> svd(sigma.whiten(parameters), Eigen::ComputeThinV);
  Index strong = 0;
  while (strong < svd.singularValues().size() && svd.singularValues()(strong) > 1.0) ++strong;
  if (strong == 0) return MatrixXd(parameters.rows(), 0);
  const MatrixXd span = M.whiten(parameters * svd.matrixV().leftCols(strong));
  return Eigen::HouseholderQR<MatrixXd>(span).householderQ() * MatrixXd::Identity(span.rows(), strong);
}

}  // namespace

std::vector<Metric> metrics_of(const std::vector<Cell>& cells, const Scatter& scatter,
                               const MetricGrid& grid) {
  std::vector<Metric> without, with;
  const Index n = scatter.noise.rows();
  const double log_noises = std::log(static_cast<double>(grid.noise_factors.size()));
  const double log_kinds =
      std::log(static_cast<double>(grid.amplitudes.size() * grid.lengths_in_cells.size()));
  for (const double factor : grid.noise_factors) {
    const MatrixXd sigma = factor * factor * scatter.noise + scatter.numerics;
    const Whitener noise(sigma), M(sigma + scatter.parameters * scatter.parameters.transpose());
    const MatrixXd plain = M.whiten(MatrixXd::Identity(n, n));
    without.push_back({plain, M.log_determinant(), -log_noises, factor});
    const MatrixXd span = strong_span(scatter.parameters, noise, M);
    const MatrixXd off = MatrixXd::Identity(n, n) - span * span.transpose();
    for (const double cells_long : grid.lengths_in_cells) {
      const double length = cells_long * cells.front().height;
      const MatrixXd kernel = noise_covariance(cells, {Kernel::matern_32, 1.0, length});
      const MatrixXd K = off * M.whiten(M.whiten(kernel).transpose()) * off;
      const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (K + K.transpose()));
      const MatrixXd rotated = eigen.eigenvectors().transpose() * plain;
      for (const double amplitude : grid.amplitudes) {
        const Eigen::ArrayXd variance =
            1.0 + amplitude * amplitude * eigen.eigenvalues().array().cwiseMax(0.0);
        with.push_back({variance.rsqrt().matrix().asDiagonal() * rotated,
                        M.log_determinant() + variance.log().sum(), -log_noises - log_kinds, factor,
                        amplitude, length});
      }
    }
  }
  without.insert(without.end(), with.begin(), with.end());
  return without;
}

}  // namespace cpt::diagnosis

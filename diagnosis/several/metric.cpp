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

Metric Metric::on_rows(const MatrixXd& covariance, const std::vector<Index>& rows) const {
  const Whitener part(covariance(rows, rows));
  Metric made = *this;
  const auto n = static_cast<Index>(rows.size());
  made.whitening = part.whiten(MatrixXd::Identity(n, n));
  made.log_determinant = part.log_determinant();
  return made;
}

std::vector<Metric> metrics_of(const std::vector<Cell>& cells, const Scatter& scatter,
                               const MetricGrid& grid) {
  std::vector<Metric> without, with;
  const Index n = scatter.numerics.rows();
  const double log_kinds =
      std::log(static_cast<double>(grid.amplitudes.size() * grid.lengths_in_cells.size()));
  for (std::size_t k = 0; k < scatter.noises.size(); ++k) {
    const auto& [covariance, log_prior] = scatter.noises[k];
    const MatrixXd sigma = covariance + scatter.numerics;
    const Whitener noise(sigma), M(sigma + scatter.parameters * scatter.parameters.transpose());
    const MatrixXd plain = M.whiten(MatrixXd::Identity(n, n));
    without.push_back({plain, M.log_determinant(), log_prior, k});
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
                        M.log_determinant() + variance.log().sum(), log_prior - log_kinds, k, amplitude,
                        length});
      }
    }
  }
  without.insert(without.end(), with.begin(), with.end());
  return without;
}

}  // namespace cpt::diagnosis

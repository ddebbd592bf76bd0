#include "diagnosis/covariance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {
namespace {

double correlation(Kernel kernel, double distance, double length) {
  const double x = distance / length;
  if (kernel == Kernel::ar1) return std::exp(-x);
  return (1.0 + std::numbers::sqrt3 * x) * std::exp(-std::numbers::sqrt3 * x);
}

double longest_sounding(const std::vector<Cell>& cells) {
  double longest = 0.0;
  for (std::size_t i = 0, top = 0; i < cells.size(); ++i) {
    if (!cells[i].same_curve(cells[top])) top = i;
    longest = std::max(longest, cells[i].depth - cells[top].depth + cells[i].height);
  }
  return longest;
}

struct Likelihood {
  double value;
  double deviation;
};

Likelihood restricted_likelihood(const std::vector<Cell>& cells, const MatrixXd& samples,
                                 const MatrixXd& trends, Kernel kernel, double length) {
  const Whitener unit(noise_covariance(cells, {kernel, 1.0, length}));
  MatrixXd y = unit.whiten(samples);
  double log_determinant = unit.log_determinant();
  if (trends.cols() > 0) {
    const Eigen::HouseholderQR<MatrixXd> qr(unit.whiten(trends));
    y = (qr.householderQ().adjoint() * y).eval().bottomRows(y.rows() - trends.cols());
    log_determinant += 2.0 * qr.matrixQR().diagonal().array().abs().log().sum();
  }
  const auto freedom = static_cast<double>(y.size());
  const double variance = std::max(y.squaredNorm() / freedom, std::numeric_limits<double>::min());
  const auto columns = static_cast<double>(samples.cols());
  return {-0.5 * (freedom * std::log(variance) + columns * log_determinant), std::sqrt(variance)};
}

// Independent columns that know nothing of the repeats' mean (Helmert's contrasts).
MatrixXd contrasts(const MatrixXd& repeats) {
  MatrixXd result(repeats.rows(), repeats.cols() - 1);
  for (Index k = 1; k < repeats.cols(); ++k) {
    const auto count = static_cast<double>(k);
    result.col(k - 1) =
        (repeats.leftCols(k).rowwise().sum() - count * repeats.col(k)) / std::sqrt(count * (count + 1.0));
  }
  return result;
}

}  // namespace

MatrixXd noise_covariance(const std::vector<Cell>& cells, const NoiseModel& noise) {
  const auto n = static_cast<Index>(cells.size());
  MatrixXd covariance = MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Cell &a = cells[static_cast<std::size_t>(i)], &b = cells[static_cast<std::size_t>(j)];
      if (a.same_curve(b))
        covariance(i, j) = noise.deviation * noise.deviation *
                           correlation(noise.kernel, std::abs(a.depth - b.depth), noise.length);
    }
  return covariance;
}

NoiseModel fit_noise(const std::vector<Cell>& cells, const MatrixXd& samples, const MatrixXd& trends,
                     double longest, Kernel kernel) {
  if (samples.rows() <= trends.cols() || samples.cols() == 0)
    throw std::invalid_argument("too few values to fit a noise");
  const auto likelihood = [&](double length) {
    return restricted_likelihood(cells, samples, trends, kernel, length);
  };
  double best = 0.2 * cells.front().height;
  double highest = likelihood(best).value;
  const auto search = [&](double from, double to, int steps) {
    for (int i = 0; i <= steps; ++i) {
      const double length = from * std::pow(to / from, static_cast<double>(i) / steps);
      const double value = likelihood(length).value;
      if (value > highest) {
        highest = value;
        best = length;
      }
    }
  };
  const double shortest = best;
  longest = std::max(longest, 2.0 * shortest);
  search(shortest, longest, 24);
  const double step = std::pow(longest / shortest, 1.0 / 24.0);
  search(std::max(best / step, shortest), std::min(best * step, longest), 16);
  return {kernel, likelihood(best).deviation, best};
}

NoiseModel noise_of_high_pass(const std::vector<Cell>& cells, const VectorXd& recorded, double wavelength,
                              Kernel kernel) {
  std::vector<VectorXd> waves;
  const auto n = static_cast<Index>(cells.size());
  for (Index top = 0, bottom = 0; top < n; top = bottom) {
    const auto cell = [&](Index i) { return cells[static_cast<std::size_t>(i)]; };
    while (bottom < n && cell(bottom).same_curve(cell(top))) ++bottom;
    const double from = cell(top).depth - 0.5 * cell(top).height;
    const double extent = cell(bottom - 1).depth + 0.5 * cell(bottom - 1).height - from;
    const auto add = [&](auto shape) {
      VectorXd wave = VectorXd::Zero(n);
      for (Index i = top; i < bottom; ++i) wave(i) = shape((cell(i).depth - from) / extent);
      waves.push_back(wave);
    };
    // Cosines are flat at both ends; the line and the parabola give the trend its slopes there.
    add([](double x) { return x; });
    add([](double x) { return x * x; });
    for (int k = 0; k == 0 || 2.0 * extent / k >= wavelength; ++k)
      add([k](double x) { return std::cos(std::numbers::pi * k * x); });
  }
  MatrixXd trends(n, static_cast<Index>(waves.size()));
  for (std::size_t k = 0; k < waves.size(); ++k) trends.col(static_cast<Index>(k)) = waves[k];
  return fit_noise(cells, recorded, trends, 0.25 * wavelength, kernel);
}

ShrunkCovariance covariance_of_repeats(const std::vector<Cell>& cells, const MatrixXd& repeats,
                                       Kernel kernel) {
  if (repeats.cols() < 3) throw std::invalid_argument("three repeats or more are needed");
  const MatrixXd samples = contrasts(repeats);
  const auto freedom = static_cast<double>(samples.cols());
  ShrunkCovariance result;
  result.target =
      fit_noise(cells, samples, MatrixXd(repeats.rows(), 0), 0.5 * longest_sounding(cells), kernel);
  const MatrixXd T = noise_covariance(cells, result.target);
  const MatrixXd S = samples * samples.transpose() / freedom;
  const double chance = (T.squaredNorm() + T.trace() * T.trace()) / freedom;
  const double apart = (S - T).squaredNorm();
  result.weight = apart > chance ? chance / apart : 1.0;
  result.covariance = result.weight * T + (1.0 - result.weight) * S;
  return result;
}

MatrixXd low_rank_plus_diagonal(const MatrixXd& residuals, int rank) {
  const Index n = residuals.rows();
  if (residuals.cols() == 0) return MatrixXd::Zero(n, n);
  const MatrixXd scaled = residuals / std::sqrt(static_cast<double>(residuals.cols()));
  const Eigen::JacobiSVD<MatrixXd> svd(scaled, Eigen::ComputeThinU);
  const Index kept = std::min<Index>(rank, svd.singularValues().size());
  const MatrixXd factors = svd.matrixU().leftCols(kept) * svd.singularValues().head(kept).asDiagonal();
  MatrixXd covariance = factors * factors.transpose();
  covariance.diagonal() = scaled.rowwise().squaredNorm();
  return covariance;
}

}  // namespace cpt::diagnosis

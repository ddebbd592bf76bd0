#include "diagnosis/several/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "diagnosis/covariance.hpp"
#include "diagnosis/quadrature.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {
namespace {

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

VectorXd smoothed_variance(const std::vector<Cell>& cells, const MatrixXd& samples) {
  constexpr Index reach = 3;
  constexpr double prior_runs = 2.0;
  const auto freedom = static_cast<double>(samples.cols());
  const VectorXd raw = samples.rowwise().squaredNorm() / freedom;
  VectorXd smooth(raw.size());
  const auto n = raw.size();
  for (Index top = 0, bottom = 0; top < n; top = bottom) {
    const auto cell = [&](Index i) { return cells[static_cast<std::size_t>(i)]; };
    while (bottom < n && cell(bottom).same_curve(cell(top))) ++bottom;
    // Of the logarithm: a few cells that scatter much say nothing of the others.
    const double usual = std::exp(raw.segment(top, bottom - top).cwiseMax(1e-18).array().log().mean());
    for (Index i = top; i < bottom; ++i) {
      const Index from = std::max(top, i - reach), to = std::min(bottom, i + reach + 1);
      smooth(i) =
          (freedom * raw.segment(from, to - from).mean() + prior_runs * usual) / (freedom + prior_runs);
    }
  }
  return smooth;
}

// Parabola and cosines longer than the wavelength in one stretch.
MatrixXd waves(const std::vector<Cell>& cells, const std::vector<Index>& stretch, double wavelength) {
  const auto depth = [&](Index i) {
    return cells[static_cast<std::size_t>(stretch[static_cast<std::size_t>(i)])].depth;
  };
  const auto n = static_cast<Index>(stretch.size());
  const double extent = depth(n - 1) - depth(0) + cells.front().height;
  std::vector<VectorXd> all;
  const auto add = [&](auto shape) {
    VectorXd wave(n);
    for (Index i = 0; i < n; ++i) wave(i) = shape((depth(i) - depth(0)) / extent);
    all.push_back(std::move(wave));
  };
  add([](double x) { return x; });
  add([](double x) { return x * x; });
  for (int k = 0; k == 0 || 2.0 * extent / k >= wavelength; ++k)
    add([k](double x) { return std::cos(std::numbers::pi * k * x); });
  MatrixXd made(n, static_cast<Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) made.col(static_cast<Index>(k)) = all[k];
  return made;
}

// ln of the restricted likelihood of y with covariance C beside trends.
double restricted(const MatrixXd& C, const VectorXd& y, const MatrixXd& trends) {
  const Whitener whitener(C);
  const Eigen::HouseholderQR<MatrixXd> qr(whitener.whiten(trends));
  const VectorXd rest =
      (qr.householderQ().adjoint() * whitener.whiten(y)).bottomRows(y.size() - trends.cols());
  return -0.5 * (rest.squaredNorm() + whitener.log_determinant()) -
         qr.matrixQR().diagonal().array().abs().log().sum();
}

}  // namespace

MatrixXd measurement_covariance(const std::vector<Cell>& cells, const VectorXd& simulated,
                                std::span<const ChannelNoise> channels) {
  const auto n = static_cast<Index>(cells.size());
  MatrixXd covariance = MatrixXd::Zero(n, n);
  const auto deviation = [&](Index i) {
    const ChannelNoise& noise =
        channels[static_cast<std::size_t>(cells[static_cast<std::size_t>(i)].channel)];
    return std::hypot(noise.relative, noise.floor / std::exp(simulated(i)));
  };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const Cell &a = cells[static_cast<std::size_t>(i)], &b = cells[static_cast<std::size_t>(j)];
      if (!a.same_curve(b)) continue;
      const double length = channels[static_cast<std::size_t>(a.channel)].length;
      covariance(i, j) = deviation(i) * deviation(j) * std::exp(-std::abs(a.depth - b.depth) / length);
    }
  return covariance;
}

MatrixXd scatter_of_repeats(const std::vector<Cell>& cells, const MatrixXd& repeats) {
  if (repeats.cols() < 3) throw std::invalid_argument("three repeats or more are needed");
  const MatrixXd samples = contrasts(repeats);
  const auto freedom = static_cast<double>(samples.cols());
  const VectorXd deviation = smoothed_variance(cells, samples).cwiseSqrt().cwiseMax(1e-9);
  const double longest = 0.5 * (cells.back().depth - cells.front().depth + cells.front().height);
  NoiseModel unit = fit_noise(cells, deviation.cwiseInverse().asDiagonal() * samples,
                              MatrixXd(samples.rows(), 0), std::max(longest, 4.0 * cells.front().height));
  unit.deviation = 1.0;
  const MatrixXd T = deviation.asDiagonal() * noise_covariance(cells, unit) * deviation.asDiagonal();
  const MatrixXd S = samples * samples.transpose() / freedom;
  const double chance = (T.squaredNorm() + T.trace() * T.trace()) / freedom;
  const double apart = (S - T).squaredNorm();
  const double weight = apart > chance ? chance / apart : 1.0;
  return weight * T + (1.0 - weight) * S;
}

MatrixXd beyond_scatter(const MatrixXd& errors, const MatrixXd& scatter, Index most) {
  const Index n = errors.rows(), runs = errors.cols();
  if (runs == 0) return MatrixXd(n, 0);
  const Whitener whitener(scatter);
  const Eigen::JacobiSVD<MatrixXd> svd(whitener.whiten(errors), Eigen::ComputeThinU);
  const double edge = std::sqrt(static_cast<double>(n)) + std::sqrt(static_cast<double>(runs));
  Index kept = 0;
  while (kept < std::min(most, svd.singularValues().size()) && svd.singularValues()(kept) > edge) ++kept;
  const VectorXd power =
      (svd.singularValues().head(kept).array().square() - static_cast<double>(n)) / static_cast<double>(runs);
  return whitener.colour(svd.matrixU().leftCols(kept) * power.cwiseSqrt().asDiagonal());
}

EstimatedNoise estimate_noise(const std::vector<Cell>& cells, const VectorXd& difference,
                              const MatrixXd& numerics, const std::vector<std::vector<Index>>& stretches,
                              double wavelength) {
  constexpr int levels = 25, lengths = 7, kept = 5;
  constexpr double least = 0.002, most = 0.3;  // [-] relative noise
  const double shortest = cells.front().height, longest = 0.25 * wavelength;
  const auto level = [](int i) { return least * std::pow(most / least, i / (levels - 1.0)); };
  const auto length = [&](int l) { return shortest * std::pow(longest / shortest, l / (lengths - 1.0)); };
  MatrixXd logs = MatrixXd::Zero(levels, lengths);
  Index used = 0;
  for (const std::vector<Index>& stretch : stretches) {
    if (stretch.empty()) continue;
    const MatrixXd trends = waves(cells, stretch, wavelength);
    if (static_cast<Index>(stretch.size()) < trends.cols() + 5) continue;
    used += static_cast<Index>(stretch.size()) - trends.cols();
    const std::vector<Cell> part = select(cells, stretch);
    const VectorXd y = difference(stretch);
    for (int l = 0; l < lengths; ++l) {
      const MatrixXd unit = noise_covariance(part, {Kernel::ar1, 1.0, length(l)});
      for (int i = 0; i < levels; ++i)
        logs(i, l) += restricted(numerics(stretch, stretch) + level(i) * level(i) * unit, y, trends);
    }
  }
  if (used < 10)
    throw std::invalid_argument("the recording is too short, or its layers too thin, to tell its noise");

  Index best_level = 0, best_length = 0;
  logs.maxCoeff(&best_level, &best_length);
  EstimatedNoise found;
  found.at_bound = best_length == lengths - 1;
  if (found.at_bound) logs.col(lengths - 1).setConstant(-1e9);  // what is longer is no noise
  VectorXd marginal(levels);
  for (int i = 0; i < levels; ++i) marginal(i) = log_sum_exp(logs.row(i).transpose());
  const VectorXd probability = (marginal.array() - log_sum_exp(marginal)).exp();
  const auto length_at = [&](double relative) {
    const double place = std::log(relative / least) / std::log(most / least) * (levels - 1.0);
    Index best = 0;
    logs.row(std::clamp(static_cast<Index>(std::lround(place)), Index{0}, Index{levels - 1})).maxCoeff(&best);
    return length(static_cast<int>(best));
  };
  const auto quantile = [&](double share) {
    double below = 0.0;
    for (int i = 0; i < levels; ++i) {
      const double here = probability(i);
      if (below + here >= share)
        return std::exp(std::log(level(i)) +
                        (share - below - 0.5 * here) / here * std::log(most / least) / (levels - 1.0));
      below += here;
    }
    return most;
  };
  for (int i = 0; i < levels; ++i) found.relative += probability(i) * level(i);
  found.lower = quantile(0.05);
  found.upper = quantile(0.95);
  found.length = length_at(quantile(0.5));
  for (int k = 0; k < kept; ++k) {
    const double relative = quantile((k + 0.5) / kept);
    found.noises.push_back({noise_covariance(cells, {Kernel::ar1, relative, length_at(relative)}),
                            -std::log(static_cast<double>(kept))});
  }
  return found;
}

}  // namespace cpt::diagnosis

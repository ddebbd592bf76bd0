#include "diagnosis/calibration/adaptive_metropolis.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "diagnosis/calibration/in_parallel.hpp"
#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double wanted_share = 0.234;  // Roberts, Gelman & Gilks 1997: best in many dimensions
constexpr double least_variance = 1e-10;

MatrixXd factor_of(const MatrixXd& covariance) {
  MatrixXd mended = covariance;
  mended.diagonal().array() += least_variance + 1e-8 * covariance.diagonal().mean();
  return mended.llt().matrixL();
}

class Chain {
 public:
  Chain(const LogDensity& density, const VectorXd& start, std::uint64_t seed, std::uint64_t stream)
      : density_(density),
        random_(seed, stream),
        at_(start),
        height_(density(start)),
        mean_(start),
        covariance_(0.1 * MatrixXd::Identity(start.size(), start.size())),
        log_scale_(std::log(2.38 / std::sqrt(static_cast<double>(start.size())))) {
    if (!std::isfinite(height_)) throw std::invalid_argument("a chain starts where the density is nil");
    factor_ = factor_of(covariance_);
  }

  // Shape and step follow the draws.
  void warm_up(Index steps) {
    constexpr Index refactor = 25;  // steps between new factors
    for (Index k = 1; k <= steps; ++k) {
      const double weight = std::pow(static_cast<double>(k + 1), -0.6);
      log_scale_ += weight * (step() - wanted_share);
      const VectorXd apart = at_ - mean_;
      mean_ += weight * apart;
      covariance_ += weight * (apart * apart.transpose() - covariance_);
      if (k % refactor == 0) factor_ = factor_of(covariance_);
    }
  }

  // The step alone, for the shape that is given.
  void tune(const MatrixXd& covariance, Index steps) {
    factor_ = factor_of(covariance);
    log_scale_ = std::log(2.38 / std::sqrt(static_cast<double>(at_.size())));
    for (Index k = 1; k <= steps; ++k)
      log_scale_ += std::pow(static_cast<double>(k + 1), -0.6) * (step() - wanted_share);
  }

  MatrixXd draw(Index steps) {
    MatrixXd draws(steps, at_.size());
    for (Index k = 0; k < steps; ++k) {
      (void)step();
      draws.row(k) = at_.transpose();
    }
    return draws;
  }

  [[nodiscard]] long evaluations() const { return evaluations_; }
  [[nodiscard]] long moves() const { return moves_; }
  [[nodiscard]] const MatrixXd& covariance() const { return covariance_; }

 private:
  // The probability that its proposal was to be accepted.
  double step() {
    const VectorXd proposed = at_ + std::exp(log_scale_) * (factor_ * random_.normals(at_.size()));
    const double height = density_(proposed);
    ++evaluations_;
    const double share = std::isnan(height) ? 0.0 : std::min(1.0, std::exp(height - height_));
    if (random_.uniform() < share) {
      at_ = proposed;
      height_ = height;
      ++moves_;
    }
    return share;
  }

  const LogDensity& density_;
  Random random_;
  VectorXd at_;
  double height_;
  VectorXd mean_;
  MatrixXd covariance_, factor_;
  double log_scale_;
  long evaluations_ = 1, moves_ = 0;
};

MatrixXd pooled_covariance(const std::vector<MatrixXd>& chains) {
  const Index d = chains.front().cols();
  VectorXd mean = VectorXd::Zero(d);
  double count = 0.0;
  for (const MatrixXd& chain : chains) {
    mean += chain.colwise().sum().transpose();
    count += static_cast<double>(chain.rows());
  }
  mean /= count;
  MatrixXd covariance = MatrixXd::Zero(d, d);
  for (const MatrixXd& chain : chains) {
    const MatrixXd centred = chain.rowwise() - mean.transpose();
    covariance += centred.transpose() * centred;
  }
  return covariance / (count - 1.0);
}

}  // namespace

MatrixXd Sample::thinned(Index count) const {
  const Index rows = chains.front().rows(), all = rows * static_cast<Index>(chains.size());
  count = std::min(count, all);
  MatrixXd draws(count, chains.front().cols());
  for (Index k = 0; k < count; ++k) {
    const auto at = static_cast<Index>((static_cast<double>(k) + 0.5) * static_cast<double>(all) /
                                       static_cast<double>(count));
    draws.row(k) = chains[static_cast<std::size_t>(at / rows)].row(at % rows);
  }
  return draws;
}

Sample sample(const LogDensity& log_density, const MatrixXd& starts, const SamplerOptions& options) {
  if (starts.rows() < 2) throw std::invalid_argument("convergence is told by two chains or more");
  std::vector<Chain> chains;
  for (Index c = 0; c < starts.rows(); ++c)
    chains.emplace_back(log_density, starts.row(c).transpose(), options.seed, static_cast<std::uint64_t>(c));
  MatrixXd covariance = MatrixXd::Zero(starts.cols(), starts.cols());
  in_parallel(starts.rows(), options.threads,
              [&](Index c) { chains[static_cast<std::size_t>(c)].warm_up(options.warm_up); });
  for (const Chain& one : chains) covariance += one.covariance() / static_cast<double>(chains.size());

  Sample found;
  for (Index steps = options.first_round;; steps = std::min(2 * steps, options.last_round)) {
    found.chains.assign(chains.size(), MatrixXd());
    std::vector<long> moves(chains.size());
    in_parallel(starts.rows(), options.threads, [&](Index c) {
      const auto at = static_cast<std::size_t>(c);
      chains[at].tune(covariance, steps / 4);
      const long before = chains[at].moves();
      found.chains[at] = chains[at].draw(steps);
      moves[at] = chains[at].moves() - before;
    });
    found.accepted = static_cast<double>(std::accumulate(moves.begin(), moves.end(), 0L)) /
                     static_cast<double>(steps * starts.rows());
    found.convergence.clear();
    found.converged = true;
    for (Index j = 0; j < starts.cols(); ++j) {
      MatrixXd draws(steps, starts.rows());
      for (Index c = 0; c < starts.rows(); ++c)
        draws.col(c) = found.chains[static_cast<std::size_t>(c)].col(j);
      const Convergence here = convergence(draws);
      found.converged =
          found.converged && here.r_hat < options.most_r_hat && here.least_size() > options.least_size;
      found.convergence.push_back(here);
    }
    if (found.converged || steps >= options.last_round) break;
    covariance = pooled_covariance(found.chains);
  }
  for (const Chain& chain : chains) found.evaluations += chain.evaluations();
  return found;
}

}  // namespace cpt::diagnosis

// Draws from a density that is known up to a factor: random-walk Metropolis whose proposals take the shape of
// the draws so far (Haario, Saksman & Tamminen 2001, Bernoulli 7, 223-242), with a step that is tuned to the
// share that is accepted (Andrieu & Thoms 2008, Statistics and Computing 18, 343-373, algorithm 4).
//
// A warm-up adapts within each chain. Then come rounds, each twice as long as the one before: proposals have
// the covariance of all chains' draws of the round before and do not change any more, so that a round's draws
// are of a Markov chain in the strict sense. The first round that convergence (convergence.hpp) accepts is
// the answer; what came before it is thrown away.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <functional>
#include <vector>

#include "diagnosis/calibration/convergence.hpp"

namespace cpt::diagnosis {

/// ln of the density, up to a constant; -infinity where it is nil. Several threads may ask at once.
using LogDensity = std::function<double(const Eigen::VectorXd&)>;

struct SamplerOptions {
  Eigen::Index warm_up = 1000;      ///< steps of a chain
  Eigen::Index first_round = 3000;  ///< steps of a chain
  Eigen::Index last_round = 64000;  ///< no round is longer
  double most_r_hat = 1.01;         ///< of every coordinate
  double least_size = 400.0;        ///< effective draws of all chains, bulk and tail
  std::uint64_t seed = 1;
  int threads = 1;  ///< that walk the chains, one each at most; the draws are the same with any number
};

struct Sample {
  std::vector<Eigen::MatrixXd> chains;   ///< steps x coordinates of the last round
  std::vector<Convergence> convergence;  ///< one a coordinate
  double accepted = 0.0;                 ///< share of the last round's steps
  long evaluations = 0;                  ///< of the density, all rounds
  bool converged = false;

  /// `count` draws, equally spaced over all chains; all if there are fewer.
  [[nodiscard]] Eigen::MatrixXd thinned(Eigen::Index count) const;
};

/// A chain from each row of `starts`, which should be more dispersed than the density. The same input gives
/// the same bits. Throws std::invalid_argument for fewer than two starts or one of density nil.
[[nodiscard]] Sample sample(const LogDensity& log_density, const Eigen::MatrixXd& starts,
                            const SamplerOptions& options = {});

}  // namespace cpt::diagnosis

// Evidence of effects at once, in one metric: the normal densities of all combinations of their nodes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "diagnosis/several/effect_nodes.hpp"
#include "diagnosis/several/metric.hpp"

namespace cpt::diagnosis {

inline constexpr std::size_t most_effects = 3;

/// A node of each of a subset's effects.
struct Combination {
  std::array<Index, most_effects> node = {};
  double log_weight = 0.0;  ///< ln of prior weight times density
};

/// What is to be explained, recorded less the null's mean, as the columns see it.
struct Target {
  std::vector<VectorXd> onto;  // of each effect that is prepared: its columns' products with it
  double square;               // of its length
};

class Combinations {
 public:
  /// `effects` must outlive it.
  Combinations(const Metric& metric, const std::vector<EffectNodes>& effects);

  /// Columns of these effects whitened by the metric, and their products: before they are asked for together.
  void prepare(std::span<const std::size_t> effects);

  /// Of recorded less the null's mean (n) [ln], for all effects that are prepared.
  [[nodiscard]] Target target(const VectorXd& residual) const;

  /// ln of the evidence of these effects together (at most three of them, each once), the density averaged
  /// over all combinations of their nodes. Those within `within` of the best go to `kept`, where one is
  /// given.
  [[nodiscard]] double log_evidence(const Target& target, std::span<const std::size_t> effects,
                                    std::vector<Combination>* kept = nullptr, double within = 8.0) const;

  /// ln N(residual; sum of curves, C + sum of U U^T) at one combination.
  [[nodiscard]] double log_density(const Target& target, std::span<const std::size_t> effects,
                                   const Combination& at) const {
    const auto [distance, log_determinant] = weigh(target, effects, at);
    return constant_ - 0.5 * (distance + log_determinant);
  }
  /// e^T (C + sum of U U^T)^-1 e there.
  [[nodiscard]] double distance(const Target& target, std::span<const std::size_t> effects,
                                const Combination& at) const {
    return weigh(target, effects, at).distance;
  }

 private:
  struct Weighed {
    double distance, log_determinant;  // the latter of 1 + U^T C^-1 U
  };
  [[nodiscard]] Weighed weigh(const Target& target, std::span<const std::size_t> effects,
                              const Combination& at) const;

  struct Block {
    Index first;    // its curve's column among the effect's
    Index columns;  // of its spread, behind it
  };
  struct Effect {
    std::vector<Block> blocks;  // of its nodes
    VectorXd log_weights;
    MatrixXd whitened;               // n x columns; empty until it is prepared
    std::vector<MatrixXd> products;  // columns x columns of each effect up to itself; empty until asked for
  };
  // Products of two effects' columns, rows those of k >= l.
  [[nodiscard]] const MatrixXd& products(std::size_t k, std::size_t l) const { return own_[k].products[l]; }

  const std::vector<EffectNodes>* nodes_;
  std::vector<Effect> own_;
  MatrixXd whitening_;
  double constant_;  // of a density's logarithm
};

}  // namespace cpt::diagnosis

// Which of the catalogue's effects are present together, and whether something else is: the posterior over
// all subsets of up to three effects, with and without something else.
#pragma once

#include <cstdint>

#include "diagnosis/several/combination.hpp"

namespace cpt::diagnosis {

/// Effects by their place among the problem's, ascending; and whether something else is there, too.
struct Subset {
  std::vector<std::size_t> effects;
  bool something_else = false;
  [[nodiscard]] bool is_nothing() const { return effects.empty() && !something_else; }
  [[nodiscard]] bool has(std::size_t effect) const;
  friend bool operator==(const Subset&, const Subset&) = default;
};

/// How probable subsets are before the recording is seen: each effect is there or not, independently of the
/// others, and three at most.
struct SubsetPrior {
  double expected = 1.1;         ///< number of effects, where there are many
  double most_probable = 0.15;   ///< an effect of few is no more probable than that
  double something_else = 0.15;  ///< whatever effects are there; never beside three
};

/// A combination of nodes in a metric, with its probability within the subset.
struct Place {
  std::size_t metric;
  Combination combination;
  double probability;
};

struct WeighedSubset {
  Subset subset;
  double prior, log_evidence, probability;
  std::vector<Place>
      places;  ///< of those that were looked at finely: 99 % of the probability, the best first
};

struct Explained {
  std::vector<WeighedSubset> subsets;  ///< all of them, the most probable first
  VectorXd inclusion;                  ///< of each effect: probability of the subsets that have it
  double something_else = 0.0;
  double nothing = 0.0;  ///< neither an effect nor something else
};

/// Everything that does not hang on the recording, so that many recordings can be explained.
class SubsetWeigher {
 public:
  struct Options {
    SubsetPrior prior;
    double fine_within = 9.0;    ///< in ln probability of the best: these are looked at finely
    std::size_t most_fine = 40;  ///< subsets, the best first
  };

  /// `effects` have the problem's order; their emulators are divided coarsely for a first look and finely for
  /// the subsets that it leaves. `scatter` (n x n) is that of noise and runs, as effect_nodes wants it.
  SubsetWeigher(const std::vector<CurveEmulator>& effects, const MatrixXd& scatter,
                const std::vector<Metric>& metrics, const Options& options);
  SubsetWeigher(const SubsetWeigher&) = delete;  // its combinations look at its nodes
  SubsetWeigher& operator=(const SubsetWeigher&) = delete;

  /// The same of some of the cells, as if no others were known.
  SubsetWeigher(const SubsetWeigher& whole, const std::vector<Index>& rows);

  /// `residual` (n) is the recording less the null's mean.
  [[nodiscard]] Explained explain(const VectorXd& residual) const;
  /// By the first look alone: the probability that nothing is missing.
  [[nodiscard]] double probability_of_nothing(const VectorXd& residual) const;

  [[nodiscard]] const std::vector<EffectNodes>& fine() const { return fine_; }
  [[nodiscard]] const std::vector<Metric>& metrics() const { return metrics_; }
  /// In one metric, these effects prepared. Not longer than the weigher.
  [[nodiscard]] Combinations at(std::size_t metric, std::span<const std::size_t> effects) const;

  /// Probabilities of all subsets by the first look, the most probable first; without places.
  [[nodiscard]] std::vector<WeighedSubset> glance(const VectorXd& residual) const {
    return first_look(residual);
  }

 private:
  void prepare();
  [[nodiscard]] std::vector<WeighedSubset> first_look(const VectorXd& residual) const;

  Options options_;
  std::vector<Metric> metrics_;
  std::vector<EffectNodes> coarse_, fine_;
  std::vector<Combinations> coarse_combinations_;  // of each metric
  std::vector<Subset> subsets_;
  VectorXd log_prior_;  // of each subset
};

}  // namespace cpt::diagnosis

#include "diagnosis/several/held_out_scores.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

std::vector<Index> others(Index n, const std::vector<Index>& block) {
  std::vector<Index> rest;
  for (Index i = 0; i < n; ++i)
    if (std::ranges::find(block, i) == block.end()) rest.push_back(i);
  return rest;
}

}  // namespace

VectorXd held_out_scores(const SubsetWeigher& weigher, const Subset& subset, const VectorXd& residual,
                         const std::vector<std::vector<Index>>& blocks) {
  const Index n = residual.size();
  std::vector<std::vector<Index>> parts;  // all cells, then all but each block
  parts.push_back(others(n, {}));
  for (const std::vector<Index>& block : blocks) parts.push_back(others(n, block));
  std::vector<std::size_t> effects(subset.effects.size());
  for (std::size_t k = 0; k < effects.size(); ++k) effects[k] = k;

  std::vector<std::vector<double>> logs(parts.size());  // of each metric
  for (const Metric& metric : weigher.metrics()) {
    if (metric.something_else() != subset.something_else) continue;
    const MatrixXd covariance = metric.covariance();
    for (std::size_t p = 0; p < parts.size(); ++p) {
      std::vector<EffectNodes> nodes;
      for (const std::size_t effect : subset.effects)
        nodes.push_back(weigher.fine()[effect].on_rows(parts[p]));
      Combinations combinations(metric.on_rows(covariance, parts[p]), nodes);
      combinations.prepare(effects);
      logs[p].push_back(metric.log_prior +
                        combinations.log_evidence(combinations.target(residual(parts[p])), effects));
    }
  }
  const auto evidence = [&](std::size_t p) {
    return log_sum_exp(Eigen::Map<const VectorXd>(logs[p].data(), static_cast<Index>(logs[p].size())));
  };
  VectorXd scores(static_cast<Index>(blocks.size()));
  for (std::size_t b = 0; b < blocks.size(); ++b)
    scores(static_cast<Index>(b)) = evidence(0) - evidence(b + 1);
  return scores;
}

ScoreGain score_gain(const VectorXd& better, const VectorXd& than) {
  const auto n = static_cast<double>(better.size());
  if (better.size() < 2)
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  const VectorXd gain = better - than;
  const double variance = (gain.array() - gain.mean()).square().sum() / (n - 1.0);
  return {gain.sum(), std::sqrt(n * variance)};
}

const WeighedSubset* best_without(const Explained& explained, const std::vector<std::size_t>& effects) {
  for (const WeighedSubset& weighed : explained.subsets) {
    if (weighed.subset.effects.empty() || weighed.subset.something_else) continue;
    if (std::ranges::none_of(effects, [&](std::size_t effect) { return weighed.subset.has(effect); }))
      return &weighed;
  }
  return nullptr;
}

}  // namespace cpt::diagnosis

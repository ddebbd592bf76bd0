// The proof that needs no prior odds: how well a subset of effects predicts depths that it has not seen.
#pragma once

#include "diagnosis/several/subsets.hpp"

namespace cpt::diagnosis {

/// ln p(block | all other cells) of each block under the subset, its effects' parameters, the soil and where
/// it has one something else averaged over what the other cells leave of them: ln Z(all) - ln Z(others).
[[nodiscard]] VectorXd held_out_scores(const SubsetWeigher& weigher, const Subset& subset,
                                       const VectorXd& residual,
                                       const std::vector<std::vector<Index>>& blocks);

/// How much better one prediction is than another: sum over the blocks, and its standard error from how the
/// blocks differ. NaN of fewer than two blocks.
struct ScoreGain {
  double sum, error;  // [-] of log scores
  [[nodiscard]] bool certain() const { return sum > 2.0 * error; }
};
[[nodiscard]] ScoreGain score_gain(const VectorXd& better, const VectorXd& than);

/// The most probable subset without something else that has none of these effects, but at least one: the best
/// wrong explanation. nullptr where there is none.
[[nodiscard]] const WeighedSubset* best_without(const Explained& explained,
                                                const std::vector<std::size_t>& effects);

}  // namespace cpt::diagnosis

// What a measurement would tell that has not been made: how much surer of the effects it would leave one.
#pragma once

#include <cstdint>

#include "diagnosis/several/subsets.hpp"

namespace cpt::diagnosis {

/// Averages over recordings that the measurement may bring, drawn from what is thought of effects, soil and
/// noise now.
struct ExpectedInformation {
  double before, after;                  // [nat] entropy of the subsets' probabilities
  double members_before, members_after;  ///< of the set of subsets that holds `credible`
  double halved;                         ///< probability that the set shrinks to half or less
  [[nodiscard]] double gained() const { return before - after; }  // [nat]
};

/// `both`: the weigher of what was measured and, below it, what would be, one soil in both; `residual` (m, m
/// < n) is of the first m cells. All by the first look. The same seed gives the same recordings.
[[nodiscard]] ExpectedInformation expected_information(const SubsetWeigher& both, const VectorXd& residual,
                                                       int draws, std::uint64_t seed, double credible = 0.9);

}  // namespace cpt::diagnosis

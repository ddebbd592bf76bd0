// What is said of a recording: effects that are named, groups that it does not tell apart, sets, and whether
// there is an alarm at all.
#pragma once

#include "diagnosis/several/subsets.hpp"

namespace cpt::diagnosis {

struct NamingRules {
  double named = 0.5;     ///< an effect of a higher inclusion is named
  double group = 0.8;     ///< least probability that a group has a member at work
  double credible = 0.9;  ///< probability of the set of subsets
  double gate = 0.01;     ///< least two-sided p of the best subset
};

/// Effects of which probably one is at work, but not which.
struct EffectGroup {
  std::vector<std::size_t> effects;  ///< the most probable first; none is named
  double probability;                ///< that one or more of them are
};

struct Naming {
  bool alarm = false;              ///< something is missing
  std::vector<std::size_t> named;  ///< the most probable first; none without an alarm or where the gate fails
  std::vector<EffectGroup> groups;
  bool something_else = false;   ///< more probable than not
  std::vector<std::size_t> set;  ///< places among Explained::subsets that hold `credible` of the probability
};

/// `alarm`: probability_of_nothing is below the alarm_level; `p` is that of the best subset's check. Where
/// the gate fails, something else is named in place of effects, whatever its probability.
[[nodiscard]] Naming name_effects(const Explained& explained, bool alarm, double p,
                                  const NamingRules& rules = {});

/// The level of P(nothing) that `share` of recordings with nothing missing fall below, from `draws` (n x
/// count, 100 or more) of the null: the alarm is false so often.
[[nodiscard]] double alarm_level(const SubsetWeigher& weigher, const MatrixXd& draws, double share);

}  // namespace cpt::diagnosis

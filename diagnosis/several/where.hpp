// Where the effects are: the stretches of depth in which what is missing stands out of the noise.
#pragma once

#include "diagnosis/several/summary.hpp"

namespace cpt::diagnosis {

/// A stretch of one curve.
struct EffectInterval {
  int sounding, channel;
  double from, to;          // [m]
  double effect;            // [ln] mean over it of what is missing
  double over_refitted;     // [ln] mean over it of the recording over the refitted curve without effects
  std::vector<Index> rows;  ///< its cells
};

/// Where the effect exceeds the noise, to one side of it, with more than this probability. Single cells
/// between are counted in, stretches of fewer than two cells left out.
struct IntervalRules {
  double probability = 0.9;
  Index least_cells = 2;
};

/// `effects` is the band of all effects together, `noise` (n) [ln] the standard deviation of the recording,
/// `difference` (n) [ln] the recording less the refitted curve without effects.
[[nodiscard]] std::vector<EffectInterval> where_effects_are(const std::vector<Cell>& cells,
                                                            const Band& effects, const VectorXd& noise,
                                                            const VectorXd& difference,
                                                            const IntervalRules& rules = {});

}  // namespace cpt::diagnosis

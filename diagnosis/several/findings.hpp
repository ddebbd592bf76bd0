// The second edition of the diagnosis, in the order of the method: scatter, subsets at the prior's soil,
// alarm, subsets at the soil that is found, gate, names, curves, held-out depths.
#pragma once

#include <optional>

#include "diagnosis/diagnose.hpp"
#include "diagnosis/several/answer.hpp"
#include "diagnosis/several/held_out_scores.hpp"
#include "diagnosis/several/noise.hpp"
#include "diagnosis/several/summary.hpp"

namespace cpt::diagnosis {

/// What is known of a channel beside its recording.
struct ChannelFacts {
  std::optional<ChannelNoise> noise;  ///< none: estimated, q_c alone
  double floor = 0.0;                 // [Pa] noise beside the estimated one
  /// [ln] standard deviation of a factor, one in each sounding: of a channel that the simulation gets wrong
  /// in level. 0: none.
  double factor = 0.0;
};

struct SeveralOptions {
  SubsetWeigher::Options subsets;
  MetricGrid metrics;
  NamingRules rules;
  double false_alarms = 0.03;  ///< share of recordings with nothing missing that may raise one
  int null_draws = 200;        ///< that the alarm's level comes from
  int most_passes = 3;      ///< looks again from where the soil is, after the first from the prior's middle
  double settled = 0.1;     ///< [standard deviations of the prior] no further look where the soil moved less
  double high_pass = 0.15;  // [m] wavelength, where the noise is estimated
  double held_out = 0.04;   // [m] of a block
  std::vector<double> soil_boundaries =
      {};              // [m] where soils meet: no noise is estimated within `away` of them
  double away = 0.04;  // [m]
  std::uint64_t seed = 1;
};

struct Findings {
  std::vector<Index> rows;  ///< of the problem that were compared; all vectors refer to them
  std::vector<Cell> cells;
  std::optional<EstimatedNoise> noise;  ///< where it was not known
  VectorXd recorded, baseline;          // n [ln]
  VectorXd null_mean;                   // n [ln]: what the effects are counted from
  VectorXd deviation;                   // n [ln] of noise and numerics together
  Explained explained;
  double nothing = 0.0;  ///< P(nothing) that the alarm goes by: by the first look
  double alarm_level = 0.0;
  TwoSidedCheck check;  ///< of the most probable subset
  Naming naming;
  Summary summary;                                    ///< averaged over all subsets
  Summary best;                                       ///< of the most probable subset
  std::optional<ScoreGain> over_wrong, over_nothing;  ///< of the most probable subset, where it has an effect
  std::optional<Subset> wrong;                        ///< the best wrong explanation
  std::vector<std::vector<Index>> blocks;             ///< that were held out
};

/// `channels`: one for each channel of the cells. Throws as diagnose().
[[nodiscard]] Findings find_several(const Problem& problem, const std::vector<ChannelFacts>& channels,
                                    const SeveralOptions& options = {});

}  // namespace cpt::diagnosis

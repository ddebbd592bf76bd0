// The whole diagnosis, in the order of the method: noise, null, locate, name, gate, isolate, hold out.
#pragma once

#include <optional>

#include "diagnosis/covariance.hpp"
#include "diagnosis/held_out.hpp"
#include "diagnosis/isolability.hpp"
#include "diagnosis/locate.hpp"
#include "diagnosis/predictive_check.hpp"
#include "diagnosis/unknown.hpp"

namespace cpt::diagnosis {

/// What is known before; n cells in all, NaN where a value is missing.
struct Problem {
  std::vector<Cell> cells;
  VectorXd recorded;                        // n [ln q_c]
  VectorXd baseline;                        // n
  std::vector<ParameterEffect> parameters;  ///< one-at-a-time runs
  MatrixXd repeats;  // n x 3 or more: the baseline with other seeds, meshes, time steps; or n x 0
  JointRuns joint;   ///< runs with several parameters changed; may be none
  std::vector<MechanismEffect> mechanisms;
  std::optional<NoiseModel> measurement;  ///< if none: from the recording's high-pass part
  double numerical_shares = 1.0;  ///< of the repeats' covariance: 1 for the baseline's own scatter; 2 if the
                                  ///< recording too is a single run of a solver
};

struct Options {
  LocateOptions locate;
  GridOptions grid;
  UnknownOptions unknown;
  double prior_nothing = 0.3;      ///< that nothing is missing
  double prior_unknown = 0.2;      ///< that something outside the catalogue is; the mechanisms share the rest
  double alarm = 0.05;             ///< something is missing only if P(nothing) is below this
  double gate = 0.01;              ///< least p of the predictive check
  double indistinguishable = 2.5;  ///< [standard deviations] D_ij below it
  double credible = 0.95;        ///< probability of the set of answers; it held 90 % of development's truths
  double high_pass = 0.15;       // [m] wavelength, where the measurement noise is not given
  double held_out_length = 0.1;  // [m] of a block; a quarter of a shorter sounding, but 3 correlation lengths
  int bootstraps = 1000;
  int pairs_of = 3;         ///< the best few mechanisms whose pairs are tried
  bool sensitivity = true;  ///< to the widths of the priors
  std::uint64_t seed = 1;
};

/// Labels of the answers: mechanism k is k, then these two.
inline constexpr const char* nothing_is_missing = "nothing is missing";
inline constexpr const char* none_of_these = "none of these";

struct Hypothesis {
  std::string name;
  double prior, log_evidence, probability;
};

/// The answer with other prior widths.
struct PriorVariation {
  std::string what;
  std::string answer;
  bool changed;
};

/// All that was found. Vectors of cells refer to `cells`, the complete rows of the problem's.
struct Diagnosis {
  std::vector<Index> rows;  ///< of the problem
  std::vector<Cell> cells;
  NoiseModel measurement;
  std::optional<ShrunkCovariance> numerical;
  Recalibration recalibrated;  ///< the null at its best
  PredictiveCheck null_check;
  Location location;
  std::vector<Hypothesis> hypotheses;  ///< the mechanisms, nothing is missing, none of these
  std::vector<MechanismEvidence> mechanisms;
  std::vector<PairEvidence> pairs;      ///< the most probable first
  std::size_t winner;                   ///< of the hypotheses, before the gate
  std::optional<PredictiveCheck> gate;  ///< of the winner, unless that is "none of these"
  std::size_t answer;                   ///< of the hypotheses, after the gate
  std::vector<std::size_t>
      set;               ///< hypotheses that the recording does not tell apart, and `Options::credible`
  MatrixXd isolability;  // D_ij; the last column D_i0
  std::vector<NextMeasurement> next;    ///< filled in by what rank_next_measurements says
  std::optional<std::size_t> best;      ///< the most probable mechanism, which the rest is about
  Recalibration with_best;              ///< the null recalibrated beside it; curve includes it
  std::vector<Recalibration> with;      ///< the same for every mechanism
  std::optional<HeldOutGain> held_out;  ///< of it; none if one block would be all
  std::vector<PriorVariation> variations;
};

/// What the steps work on: the problem on its complete cells, the null model and the mechanisms' emulators.
struct Prepared {
  Problem problem;
  std::vector<Index> rows;  ///< of the problem as given
  NoiseModel measurement;
  std::optional<ShrunkCovariance> numerical;
  NullModel null;
  std::vector<CurveEmulator> emulators;
};

/// Throws as diagnose.
[[nodiscard]] Prepared prepare(const Problem& problem, const Options& options = {});

/// Throws std::invalid_argument if fewer than 10 cells are complete, shapes disagree or a covariance is not
/// positive definite. The same problem and options give the same bits.
[[nodiscard]] Diagnosis diagnose(const Problem& problem, const Options& options = {});

/// The mechanisms of the answer's set.
[[nodiscard]] std::vector<std::size_t> mechanisms_in_set(const Diagnosis& diagnosis);

/// The recording at hand, to be held against what could be measured next.
[[nodiscard]] Observation observation_of(const std::string& name, const Problem& problem,
                                         const Options& options = {});

/// What would tell the mechanisms of the answer's set apart best, the best first; nothing where the set has
/// fewer than two. The candidates hold the problem's mechanisms in its order.
[[nodiscard]] std::vector<NextMeasurement> rank_next_measurements(const Observation& present,
                                                                  const Diagnosis& diagnosis,
                                                                  const std::vector<Observation>& candidates);

}  // namespace cpt::diagnosis

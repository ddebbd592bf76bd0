// The whole diagnosis, in the order of the method: noise, null, locate, name, gate, isolate, hold out.
#pragma once

#include <optional>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/unknown.hpp"

namespace cpt::diagnosis {

/// What is known before; n cells in all, NaN where a value is missing.
struct Problem {
  std::vector<Cell> cells;
  VectorXd recorded;                        // n [ln q_c]
  VectorXd baseline;                        // n
  std::vector<ParameterEffect> parameters;  ///< one-at-a-time runs
  MatrixXd correlation;                     ///< of their standard normals (p x p); empty: independent
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

/// The problem on the cells where every curve has a value; `rows` are those of the problem that it keeps.
/// Throws std::invalid_argument if fewer than 10 are complete or shapes disagree.
[[nodiscard]] Problem complete_cells(const Problem& problem, std::vector<Index>& rows);

/// What the steps work on: the problem on its complete cells, the null model and the mechanisms' emulators.
struct Prepared {
  Problem problem;
  Compared compared;  ///< rows of the problem as given
  NullModel null;
  std::vector<CurveEmulator> emulators;
};

/// Throws as diagnose.
[[nodiscard]] Prepared prepare(const Problem& problem, const Options& options = {});

/// Throws std::invalid_argument if fewer than 10 cells are complete, shapes disagree or a covariance is not
/// positive definite. The same problem and options give the same bits.
[[nodiscard]] Diagnosis diagnose(const Problem& problem, const Options& options = {});

/// The recording at hand, to be held against what could be measured next.
[[nodiscard]] Observation observation_of(const std::string& name, const Problem& problem,
                                         const Options& options = {});

/// What would tell the mechanisms of the answer's set apart best, the best first; nothing where the set has
/// fewer than two. The candidates hold the problem's mechanisms in its order.
[[nodiscard]] std::vector<NextMeasurement> rank_next_measurements(const Observation& present,
                                                                  const Diagnosis& diagnosis,
                                                                  const std::vector<Observation>& candidates);

}  // namespace cpt::diagnosis

// What the design of a study says: the numbers of its estimator for every window, from the stored runs.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "results/ledger/snapshot.hpp"
#include "results/statistics/propagation_rows.hpp"
#include "results/tables/table_format.hpp"

namespace cpt::results {

/// One number of the design's estimator, with its 95 % interval. NaN where undefined; the note says why.
struct EffectRow {
  std::string window, parameter;
  std::string other_parameter;  ///< of a pair
  /// interaction; mu_star, mu, sigma; first_order, total_order, shapley, Q2; mean, standard_deviation,
  /// quantile_05
  /// ..., exceedance
  std::string quantity;
  std::string unit;  ///< the window's, as "kPa", or "-" for a share of the variance and a probability
  double value, lower, upper;
  int used = 0;     ///< elementary effects (morris), rows (sobol), else runs
  int dropped = 0;  ///< of the same, because a run has no result
  std::string note;
  std::string method = {};  ///< how value and interval were estimated
  int runs = 0;             ///< with results, that it was estimated from
  double threshold_kPa = std::numeric_limits<double>::quiet_NaN();  ///< of an exceedance
};

struct Effects {
  std::string design = "one_at_a_time";  ///< its kind
  std::vector<int> runs;        ///< the design's realizations in its order, as far as the ledger has them
  std::vector<EffectRow> rows;  ///< by window, quantity, then parameter in the design's order
  std::vector<ConvergenceRow> convergence;  ///< of a propagation
  /// What the first runs of morris, latin_hypercube or sobol alone would say: add_index_convergence.
  std::vector<EffectRow> index_convergence;
  std::vector<DepthBandRow> bands;  ///< of a propagation
  std::string stopped;              ///< of a design with a rule to stop: what it says, in a sentence
  /// Of a propagation to which one is added: "5 % of q_c, 35 % of f_s"; else empty.
  std::string numerical_error;
  std::string problem;  ///< why the stored study cannot be read; empty if it can
};

/// "3 of 4 repeats so far"; empty once none is to come.
[[nodiscard]] std::string repeats_so_far(const Snapshot& campaign);

/// The design is that of the study's text in the ledger. No rows for a study without [design], whose indices
/// are Snapshot::sensitivity, and for a ledger that holds none of the design's runs. Runs that failed or have
/// not been made are left out as each estimator says (parameters/designs/), and counted.
[[nodiscard]] Effects design_effects(const Snapshot& campaign);

[[nodiscard]] Table effects_table(const Effects& effects);
[[nodiscard]] Table bands_table(const Effects& effects);

/// Fills Effects::index_convergence of morris, latin_hypercube and sobol: mu_star or total_order of every
/// window and parameter from the first sixth of the trajectories, runs or rows, from two sixths and so on.
/// Steps whose runs tell nothing have no rows.
void add_index_convergence(const Snapshot& campaign, Effects& effects);

/// The same columns as of effects_table.
[[nodiscard]] Table index_convergence_table(const Effects& effects);

}  // namespace cpt::results

// The posterior of a study's parameters, from recordings by an emulator: draws, what they say of each
// unknown, and what they say over depth.
#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/calibration/adaptive_metropolis.hpp"
#include "diagnosis/calibration/calibration_model.hpp"

namespace cpt::diagnosis {

/// Of one unknown: mean, standard deviation and quantiles.
struct Spread {
  double mean = 0.0, deviation = 0.0, lower = 0.0, median = 0.0, upper = 0.0;  ///< 5, 50, 95 %
};

/// Of values in any order; at least one.
[[nodiscard]] Spread spread_of(const VectorXd& values);

struct CalibratedUnknown {
  std::string name, unit;  ///< of a deviation "%"
  bool is_input = true;
  Spread prior, posterior;  ///< deviations in per cent
  Convergence convergence;
  /// Standard deviation of the posterior over the prior's: how much is not learnt.
  [[nodiscard]] double left() const { return posterior.deviation / prior.deviation; }
};

/// A cell of a channel; q_c, f_s in the emulator's unit, discrepancy in per cent of the simulation.
struct CalibratedBand {
  Cell cell;
  double recorded = 0.0;
  Spread simulation;   ///< of a run with parameters of the posterior
  Spread predicted;    ///< of another recording in the same soil: with discrepancy and noise
  Spread discrepancy;  ///< of this recording from the simulation
  /// Whether 90 % of the discrepancy are on one side of zero.
  [[nodiscard]] bool apart() const { return discrepancy.lower > 0.0 || discrepancy.upper < 0.0; }
};

struct Posterior {
  std::vector<CalibratedUnknown> unknowns;         ///< inputs first
  MatrixXd draws;                                  ///< thinned, draws x unknowns; deviations in per cent
  MatrixXd prior_draws;                            ///< the same of the prior
  MatrixXd correlation;                            ///< Spearman's, of the inputs' draws
  std::vector<std::vector<CalibratedBand>> bands;  ///< of each channel its cells
  Sample sample;
};

struct CalibrateOptions {
  int chains = 4;  ///< from draws of the prior
  SamplerOptions sampler = {};
  Index kept = 2000;          ///< draws that are handed out
  Index over_depth = 400;     ///< of them, whose cells are looked at
  Index prior_draws = 40000;  ///< for the prior's spread
};

/// Draws of the model's scores, with chains from the prior.
[[nodiscard]] Sample sample_posterior(const CalibrationModel& model, const CalibrateOptions& options);

/// Throws std::invalid_argument as CalibrationModel.
[[nodiscard]] Posterior calibrate(const CalibrationModel& model, const CalibrateOptions& options);

/// Spearman's correlation of columns.
[[nodiscard]] MatrixXd rank_correlation_of(const MatrixXd& draws);

}  // namespace cpt::diagnosis

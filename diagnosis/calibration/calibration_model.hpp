// What recordings say of a study's parameters, with an emulator in the solver's place (Kennedy & O'Hagan
// 2001, Journal of the Royal Statistical Society B 63, 425-464; curves as in Higdon, Gattiker, Williams &
// Rightley 2008, Journal of the American Statistical Association 103, 570-583). Of each channel
//
//   recorded(z) = eta(z, theta) + delta(z) + epsilon(z)
//
//   eta      simulation: mean(z) + shapes(z) w(theta), scores w normal with the emulator's mean and variance
//            and the numerical scatter of runs, the same in all soundings; what the shapes leave out is
//            correlated over depth as in the runs, of each sounding for itself
//   delta    discrepancy: a Gaussian process over depth of each sounding (Matern 3/2), its standard deviation
//            half-normal a priori
//   epsilon  measurement: white, of a standard deviation that is given or half-normal a priori
//
// on the emulator's scale: the logarithm where it works on that, else the value; deviations are relative to
// the mean curve of the runs, or to a tenth of its largest value where it is less. All unknowns are normal
// scores: standard normal a priori, those of inputs with the copula's correlation.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "diagnosis/depth_grid.hpp"
#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {

/// An uncertain input. Values are in study units, of a choice the index of the alternative.
struct CalibrationInput {
  std::string name, unit;
  std::function<double(double)> value;  ///< of a normal score, rising
  std::function<double(double)> place;  ///< of a value: the emulator's coordinate
  double lower = 0.0, upper = 1.0;      ///< values that the emulator knows; beyond, the prior is cut off
};

struct ScorePrediction {
  VectorXd mean, variance;  ///< of each component, the variance with the runs' own scatter
};

/// A channel on the cells of all soundings that have it, end to end.
struct CalibrationChannel {
  std::string name;  ///< "q_c"
  bool logarithmic = false;
  std::vector<Cell> cells;
  VectorXd recorded;  ///< on the scale
  VectorXd mean;      ///< of the runs, on the scale
  MatrixXd shapes;    ///< cells x components
  MatrixXd left_out;  ///< covariance of what the shapes leave out, of which that within a sounding is used
  std::function<ScorePrediction(const Eigen::RowVectorXd& place)> scores;
  double discrepancy = 0.05;  // [-] scale of its prior, relative
  double length = 0.1;        // [m] its correlation length
  double noise = 0.01;        // [-] relative; of a prior its scale
  bool noise_is_known = true;
};

struct CalibrationProblem {
  std::vector<CalibrationInput> inputs;
  MatrixXd correlation;  ///< of the inputs' normal scores
  std::vector<std::string> soundings;
  std::vector<CalibrationChannel> channels;
};

/// A deviation beside the inputs that is found, too.
struct CalibrationDeviation {
  bool of_discrepancy;  ///< else of the noise
  std::size_t channel;
  int sounding;  ///< of a discrepancy
  double scale;  // [-] of its half-normal prior
};

/// What a point of the posterior says of a channel's cells, on its scale, relative deviations already turned.
struct CalibratedCells {
  VectorXd simulation, simulation_variance;    ///< before the recording of these cells is looked at
  VectorXd discrepancy, discrepancy_variance;  ///< given the recording
  VectorXd other_variance;                     ///< prior of the discrepancy and of the noise
};

class CalibrationModel {
 public:
  /// Throws std::invalid_argument for sizes that do not agree.
  explicit CalibrationModel(CalibrationProblem problem);

  [[nodiscard]] const CalibrationProblem& problem() const { return problem_; }
  [[nodiscard]] const std::vector<CalibrationDeviation>& deviations() const { return deviations_; }
  [[nodiscard]] Index unknowns() const {
    return static_cast<Index>(problem_.inputs.size() + deviations_.size());
  }
  /// "clay.s_u_kPa"; "discrepancy q_c first", "noise q_c"
  [[nodiscard]] std::vector<std::string> names() const;

  /// In study units; deviations are relative [-].
  [[nodiscard]] VectorXd values(const VectorXd& scores) const;
  /// What a relative deviation of one is at each cell of a channel, on its scale.
  [[nodiscard]] const VectorXd& units(std::size_t channel) const { return units_.at(channel); }
  /// Whether the emulator knows these inputs.
  [[nodiscard]] bool within(const VectorXd& values) const;
  [[nodiscard]] double log_prior(const VectorXd& scores) const;
  [[nodiscard]] double log_likelihood(const VectorXd& values) const;
  /// Prior times likelihood; -infinity outside of what the emulator knows.
  [[nodiscard]] double log_posterior(const VectorXd& scores) const;

  /// Scores from the prior within what the emulator knows.
  [[nodiscard]] VectorXd draw_prior(Random& random) const;
  [[nodiscard]] CalibratedCells cells(std::size_t channel, const VectorXd& values) const;
  /// `curve` (on the scale, at the channel's cells) with a discrepancy and noise of these deviations.
  [[nodiscard]] VectorXd draw_recording(std::size_t channel, const VectorXd& curve, const VectorXd& values,
                                        Random& random) const;
  /// The same model of other recordings, one for each channel.
  [[nodiscard]] CalibrationModel with_recordings(const std::vector<VectorXd>& recorded) const;

 private:
  struct Block {  // cells of one sounding
    Index first, count;
    int sounding;
    MatrixXd correlation;  // of the discrepancy, times the units of both cells
    MatrixXd left_out;     // covariance of what the shapes leave out
  };
  [[nodiscard]] double channel_likelihood(std::size_t channel, const Eigen::RowVectorXd& place,
                                          const VectorXd& values) const;
  [[nodiscard]] Eigen::RowVectorXd place_of(const VectorXd& values) const;
  [[nodiscard]] double noise_of(std::size_t channel, const VectorXd& values) const;
  [[nodiscard]] double discrepancy_of(std::size_t channel, int sounding, const VectorXd& values) const;

  CalibrationProblem problem_;
  std::vector<CalibrationDeviation> deviations_;
  std::vector<std::vector<Block>> blocks_;  // of each channel
  std::vector<VectorXd> units_;             // of each channel: one relative unit at each cell
  MatrixXd factor_;                         // of the inputs' correlation
};

/// A half-normal deviation from its normal score: scale |Z| with the same probability below.
[[nodiscard]] double half_normal_value(double scale, double score);

}  // namespace cpt::diagnosis

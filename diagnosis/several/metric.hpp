// What a curve scatters by beside the effects: noise, numerics, the study's parameters, and something else
// that no effect of the catalogue has. Each metric is one covariance that it may have.
#pragma once

#include <vector>

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

/// One covariance C of the curve about its mean.
struct Metric {
  MatrixXd whitening;      // W, n x n: W C W^T = 1
  double log_determinant;  // ln |C|
  double log_prior;        // of this metric among those with, or among those without, something else
  std::size_t noise = 0;   // which of Scatter::noises
  double amplitude = 0.0;  // [ln] standard deviation of something else; 0: there is none
  double length = 0.0;     // [m] its correlation length
  [[nodiscard]] bool something_else() const { return amplitude > 0.0; }
  [[nodiscard]] MatrixXd covariance() const { return (whitening.transpose() * whitening).inverse(); }
  /// On some of the cells, by this covariance, which is its own.
  [[nodiscard]] Metric on_rows(const MatrixXd& covariance, const std::vector<Index>& rows) const;
};

/// What the covariances are made of.
struct Scatter {
  /// What the measurement may scatter by; one where it is known.
  struct Noise {
    MatrixXd covariance;  // n x n [ln^2]
    double log_prior;     // of all: they sum to 1
  };
  std::vector<Noise> noises;
  MatrixXd numerics;    // n x n [ln^2] of runs, and of the response surface
  MatrixXd parameters;  // n x k [ln]: times independent standard normals, what the study's parameters do
};

/// What something else may be, each as probable as the others.
struct MetricGrid {
  std::vector<double> amplitudes = {0.03, 0.08, 0.2, 0.5};
  std::vector<double> lengths_in_cells = {3.0, 8.0, 20.0};
};

/// Something else is Matern-3/2 over depth, off what the parameters can do above the noise (a level that they
/// can give needs nothing else), in each sounding and channel by itself. Those without it come first. Throws
/// std::invalid_argument where a covariance is not positive definite.
[[nodiscard]] std::vector<Metric> metrics_of(const std::vector<Cell>& cells, const Scatter& scatter,
                                             const MetricGrid& grid);

}  // namespace cpt::diagnosis

// How recording and simulation scatter, cell by cell: the instrument's class, runs of the solver among
// themselves, and what a finer preset moves.
#pragma once

#include <span>

#include "diagnosis/several/metric.hpp"

namespace cpt::diagnosis {

/// Of one channel's recording: standard deviation sqrt((percent q)^2 + floor^2), correlated over `length`.
struct ChannelNoise {
  double relative = 0.01;  // [-]
  double floor = 0.0;      // [Pa]
  double length = 0.01;    // [m] of the AR(1) correlation
};

/// n x n [ln^2] by the channel of each cell; `simulated` (n) [ln Pa] tells where the floor counts.
[[nodiscard]] MatrixXd measurement_covariance(const std::vector<Cell>& cells, const VectorXd& simulated,
                                              std::span<const ChannelNoise> channels);

/// Of runs that differ in seed, mesh and time step alone (n x 3 or more): w T + (1 - w) S as
/// covariance_of_repeats, but the target T has a standard deviation of its own in every cell, the sample's
/// smoothed over seven cells of a curve and drawn towards the curve's usual one (geometric mean) with the
/// weight of two repeats: runs scatter most where soils meet. Throws std::invalid_argument for fewer than
/// three.
[[nodiscard]] MatrixXd scatter_of_repeats(const std::vector<Cell>& cells, const MatrixXd& repeats);

/// n x k [ln]: times independent standard normals, what is left of errors of some fit (n x runs) [ln] beyond
/// the scatter that every run has. `scatter` is its covariance. In its metric, principal components larger
/// than those of as many runs of nothing but scatter, each less what scatter adds to it (the edge of
/// Marchenko & Pastur 1967, Mathematics of the USSR-Sbornik 1, 457); at most `most`.
[[nodiscard]] MatrixXd beyond_scatter(const MatrixXd& errors, const MatrixXd& scatter, Index most);

/// A recording whose noise is not known: hypotheses for a relative one, from what is left of recorded less
/// simulated (n) [ln] beside a parabola and waves longer than `wavelength` [m] in each stretch, the runs' own
/// scatter counted in. A stretch is a part of one curve within one soil, away from where soils meet: there
/// layers would be taken for noise.
struct EstimatedNoise {
  std::vector<Scatter::Noise> noises;  ///< five of equal probability
  double relative = 0.0;               // [-] posterior mean
  double lower = 0.0, upper = 0.0;     // [-] 90 %
  double length = 0.0;                 // [m]
  bool at_bound = false;               ///< the recording does not tell the length: it is the prior's
};
[[nodiscard]] EstimatedNoise estimate_noise(const std::vector<Cell>& cells, const VectorXd& difference,
                                            const MatrixXd& numerics,
                                            const std::vector<std::vector<Index>>& stretches,
                                            double wavelength);

}  // namespace cpt::diagnosis

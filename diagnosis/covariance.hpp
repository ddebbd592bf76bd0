// How recording and simulation scatter about each other when no physics is missing.
//
// The correlation length decides how many independent things a curve of 60 cells says; taken as zero, almost
// every null case raises an alarm. It comes from repeats of the baseline or from the recording's own
// high-pass part, never from the residual that is being judged.
#pragma once

#include "diagnosis/depth_grid.hpp"

namespace cpt::diagnosis {

enum class Kernel {
  ar1,       ///< exp(-d / l), on equal cells a first-order autoregression
  matern_32  ///< (1 + sqrt(3) d / l) exp(-sqrt(3) d / l), smoother
};

/// Stationary noise in depth, independent between soundings.
struct NoiseModel {
  Kernel kernel = Kernel::ar1;
  double deviation = 0.0;  // [ln q_c] standard deviation, >= 0
  double length = 0.0;     // [m] correlation length l, > 0
};

/// n x n covariance [ln^2] of the noise on the cells.
[[nodiscard]] MatrixXd noise_covariance(const std::vector<Cell>& cells, const NoiseModel& noise);

/// The noise of independent columns y_k = trends b_k + e_k, b_k unknown, by restricted maximum likelihood
/// (Patterson and Thompson 1971) over lengths from 0.2 cells to `longest` [m]. Cosines down to
/// a wavelength as `trends` make it the noise of the high-pass part, unbiased by the filter. Throws
/// std::invalid_argument if there are not more rows than trends.
[[nodiscard]] NoiseModel fit_noise(const std::vector<Cell>& cells, const MatrixXd& samples,
                                   const MatrixXd& trends, double longest, Kernel kernel = Kernel::ar1);

/// Of a recording (n): what is left beside a parabola and waves longer than `wavelength` [m]. The length is
/// at most a quarter of the wavelength: what is longer, the high-pass part cannot tell from a trend.
[[nodiscard]] NoiseModel noise_of_high_pass(const std::vector<Cell>& cells, const VectorXd& recorded,
                                            double wavelength, Kernel kernel = Kernel::ar1);

struct ShrunkCovariance {
  MatrixXd covariance;  // n x n [ln^2]
  NoiseModel target;    ///< the stationary fit
  double weight;        ///< of the target, in [0, 1]
};

/// From few (3 or more) repeats of one curve, n x repeats: w T + (1 - w) S, T the stationary fit, S the
/// sample covariance, w = sum Var(s_ij) / sum (s_ij - t_ij)^2 (Ledoit and Wolf 2004; Schafer and Strimmer
/// 2005), with the variances of a normal sample from T.
[[nodiscard]] ShrunkCovariance covariance_of_repeats(const std::vector<Cell>& cells, const MatrixXd& repeats,
                                                     Kernel kernel = Kernel::ar1);

/// The second moment about zero of residuals (n x runs): its `rank` first principal components, and the rest
/// of each cell's variance on the diagonal. Zero for no residuals (n x 0).
[[nodiscard]] MatrixXd low_rank_plus_diagonal(const MatrixXd& residuals, int rank = 3);

}  // namespace cpt::diagnosis

// The gate: could the winner have made this recording? If not, no posterior probability makes it the answer.
//
// Replicates are drawn from the winner with its posterior phi and from the null with its bounded parameters;
// recording and replicates are treated alike: phi is refitted on the same nodes, and the rest judged by its
// chi-square and by the greatest step in it (Gelman, Meng and Stern 1996, with the refit that keeps the p
// values from being timid).
#pragma once

#include "diagnosis/evidence.hpp"
#include "diagnosis/locate.hpp"

namespace cpt::diagnosis {

struct PredictiveCheck {
  double chi_square, chi_square_p;  // [-] |L^-1 (r - Delta)|^2 at the best phi
  double scan, scan_p;              // [-] greatest step statistic of the rest
  double p;                         // min(1, 2 min of the two)
};

/// Of the null model: no mechanism, nothing refitted but the parameters, which M contains. `null_draws` as in
/// locate.
[[nodiscard]] PredictiveCheck check_null(const std::vector<Cell>& cells, const Whitener& covariance,
                                         const VectorXd& residual, const MatrixXd& null_draws,
                                         int least_cells = 2);

/// Of a mechanism with its posterior. `null_covariance` is M; the emulator's error at the posterior's mode
/// is added to it and to the draws.
[[nodiscard]] PredictiveCheck check_mechanism(const std::vector<Cell>& cells, const MatrixXd& null_covariance,
                                              const CurveEmulator& emulator,
                                              const MechanismEvidence& posterior, const VectorXd& residual,
                                              const MatrixXd& null_draws, std::uint64_t seed,
                                              int least_cells = 2);

}  // namespace cpt::diagnosis

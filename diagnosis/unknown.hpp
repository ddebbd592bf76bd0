// "None of these": something is missing, smooth in depth, that no mechanism of the catalogue and no parameter
// gives. The competitor that keeps an unforeseen effect from being named as the catalogued one nearest to it.
#pragma once

#include "diagnosis/parameters_prior.hpp"

namespace cpt::diagnosis {

/// The prior of the discrepancy, a Gaussian process with a Matern-3/2 kernel: both hyperparameters uniform in
/// their logarithms.
struct UnknownOptions {
  double least_amplitude = 0.02;  // [ln q_c] 2 % is about what a recording can show
  double most_amplitude = 0.6;    // [ln q_c] a factor of 1.8
  int amplitudes = 12;
  double least_length = 3.0;  // [cells] shorter is noise
  double most_length = 0.5;   // [soundings' greatest extent] longer is a trend, which the parameters give
  int lengths = 6;
};

/// ln Z of null + discrepancy, made orthogonal in the metric M^-1 to span(J), averaged over the grid.
///
/// Span(J) is spanned by those directions of the parameters' effects whose standard deviation over the prior
/// is more than one standard deviation of the noise; weaker ones can neither explain nor be mistaken for a
/// mismatch, and taking them out would leave the discrepancy no room.
[[nodiscard]] double unknown_evidence(const std::vector<Cell>& cells, const NullModel& null,
                                      const VectorXd& residual, const UnknownOptions& options = {});

}  // namespace cpt::diagnosis

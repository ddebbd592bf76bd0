// What simpler methods would answer: the benchmark shows them beside the diagnosis.
#pragma once

#include "diagnosis/diagnose.hpp"

namespace cpt::validation::concealed {

/// The least-squares fit of every hypothesis, all cells alike and independent: soil parameters within their
/// bounds, the mechanism's parameters on a grid of its prior.
struct LeastSquares {
  diagnosis::VectorXd rmse;  ///< [ln q_c] of the mechanisms in order, then of "nothing is missing"
  diagnosis::VectorXd
      bic_weights;        ///< the same order; exp(-BIC / 2) over their sum (Schwarz 1978, independent errors)
  std::size_t best_rmse;  ///< the mechanism that fits best; never "nothing is missing"
  std::size_t best_bic;   ///< of the hypotheses
};
[[nodiscard]] LeastSquares least_squares(const diagnosis::Prepared& prepared);

}  // namespace cpt::validation::concealed

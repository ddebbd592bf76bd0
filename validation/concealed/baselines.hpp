// What simpler methods would answer: the benchmark shows them beside the diagnosis.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"

namespace cpt::validation::concealed {

/// The least-squares fit of every hypothesis, all cells alike and independent: soil parameters within their
/// bounds, the mechanism's parameters on a grid of its prior.
struct LeastSquares {
  struct Fit {
    std::string name;             ///< of the mechanism, or nothing_is_missing
    diagnosis::Index parameters;  ///< of the soil and the mechanism, and the error's size
    double rmse;                  ///< [ln q_c]
    double bic_weight;            ///< exp(-BIC / 2) over the sum of all (Schwarz 1978, independent errors)
  };
  std::vector<Fit> fits;  ///< of the mechanisms in the problem's order, and of "nothing is missing"

  [[nodiscard]] const Fit& of_nothing() const { return fits.back(); }
  [[nodiscard]] const Fit& least_rmse() const;  ///< of "nothing is missing" only where there is no mechanism
  [[nodiscard]] const Fit& greatest_weight() const;
};
[[nodiscard]] LeastSquares least_squares(const diagnosis::Prepared& prepared);

}  // namespace cpt::validation::concealed

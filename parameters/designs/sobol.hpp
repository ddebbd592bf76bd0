// Saltelli's scheme: Sobol' indices by plain averages, without any model of the output.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// rows (parameters + 2) runs x parameters. Row for row: A, B, then A with one column after the other from B
/// (Saltelli et al. 2010, Computer Physics Communications 181, 259-270, section 2). A and B are the halves of
/// Sobol' points in twice as many dimensions, from the zero point on (Owen 2020), moved by a random digital
/// shift; a power of two rows keeps their balance. The same seed gives the same.
[[nodiscard]] Eigen::MatrixXd sobol_places(int parameters, int rows, std::uint64_t seed);

/// Shares of the output's variance.
struct SobolIndices {
  std::vector<Estimate> first;  ///< by the parameter alone (Saltelli et al. 2010, Table 2, eq. b)
  std::vector<Estimate> total;  ///< with all its interactions (Jansen 1999; the same table, eq. f)
  int used = 0;                 ///< rows
  int dropped = 0;              ///< rows with a run without a result
};

/// `y` has the results as sobol_places orders the runs, NaN where there is none. Intervals: bootstrap over
/// rows. Indices are NaN where A and B do not vary (variation.hpp) or no row is left.
[[nodiscard]] SobolIndices sobol_indices(int parameters, const Eigen::VectorXd& y, std::uint64_t seed);

[[nodiscard]] DesignKind sobol_design();

}  // namespace cpt::parameters

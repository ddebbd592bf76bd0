// Saltelli's scheme: Sobol' indices by plain averages, without any model of the output.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// rows (parameters + 2) runs x parameters. Row for row: A, B, then A with one column after the other from B
/// (Saltelli et al. 2010, Computer Physics Communications 181, 259-270, section 2). A and B are the halves of
/// Sobol' points in twice as many dimensions, from the zero point on (Owen 2020), moved by a random digital
/// shift; a power of two rows keeps their balance. With several sections row r is the next point of section
/// r mod sections, each with a shift of its own: they are independent (L'Ecuyer & Lemieux 2002, Recent
/// advances in randomized quasi-Monte Carlo methods, section 5). The same seed gives the same.
[[nodiscard]] Eigen::MatrixXd sobol_places(int parameters, int rows, std::uint64_t seed, int sections = 1);

enum class SobolEstimator {
  /// First order: Saltelli et al. (2010), Table 2, eq. b; total order: Jansen (1999), the same table, eq. f.
  saltelli,
  /// Correlations of f(B), and of f(A), with f(A with a column of B): S = r, T = 1 - r (Martinez 2011;
  /// Baudin, Boumhaout, Delage, Iooss & Martinez 2016, International Conference on Sensitivity Analysis of
  /// Model Output). Free of the mean's size; a total order's error is smaller where the input matters much,
  /// a first order's larger where it matters little.
  martinez,
};

/// Of a study; the usual one for an empty name, std::out_of_range for another.
[[nodiscard]] SobolEstimator sobol_estimator(std::string_view name);

/// Shares of the output's variance.
struct SobolIndices {
  std::vector<Estimate> first;  ///< by the parameter alone
  std::vector<Estimate> total;  ///< with all its interactions
  int used = 0;                 ///< rows
  int dropped = 0;              ///< rows with a run without a result
};

/// `y` has the results as sobol_places orders the runs, NaN where there is none. Intervals of one section:
/// bootstrap over rows, which takes them for independent and is too wide for Sobol' points; of several: from
/// what each gives by itself (sectioning.hpp). Indices are NaN where A and B do not vary (variation.hpp) or
/// no row is left.
[[nodiscard]] SobolIndices sobol_indices(int parameters, const Eigen::VectorXd& y, std::uint64_t seed,
                                         SobolEstimator estimator = SobolEstimator::saltelli,
                                         int sections = 1);

[[nodiscard]] DesignKind sobol_design();

}  // namespace cpt::parameters

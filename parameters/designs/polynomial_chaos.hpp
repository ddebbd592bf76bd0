// Sobol' indices from a polynomial chaos expansion: a least-squares fit of orthonormal polynomials, whose
// squared coefficients are shares of the variance (Sudret 2008, Reliability Eng. & System Safety 93,
// 964-979).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "parameters/designs/bootstrap.hpp"

namespace cpt::parameters {

struct ChaosIndices {
  std::vector<Estimate> first;  ///< share of the expansion's variance by the parameter alone
  std::vector<Estimate> total;  ///< with all its interactions
  double q2;                    ///< 1 - corrected leave-one-out error over the variance of y
  int degree = 0;               ///< largest total degree, chosen by the least leave-one-out error
  int terms = 0;                ///< of the expansion
  int used = 0;                 ///< runs
  int dropped = 0;              ///< runs without a result
  std::string problem;          ///< why there are no indices, or why they are not to be believed; or empty
};

/// Below this the expansion misses more than a fifth of the variance, and its indices are not to be believed.
constexpr double least_q2 = 0.8;

/// Fits y, NaN where there is no result, over `places` in the unit cube (runs x parameters), as they were
/// run: columns are uniform, or take as many values as `values` says (0: uniform; orthonormal.hpp).
///
/// Basis: products of polynomials that are orthonormal over these places (Legendre's; 1 and -1 for a choice),
/// with hyperbolic truncation (sum of degree^0.75)^(1/0.75) <= p; p from 1 on as long as there are two runs a
/// term and 200 terms at most, the best by the analytic leave-one-out error with its correction for small
/// samples (Blatman & Sudret 2011, Journal of Computational Physics 230, 2345-2367; the correction is that of
/// Chapelle, Vapnik & Bengio 2002). Intervals: bootstrap over the runs with the basis kept (Marelli & Sudret
/// 2018, Structural Safety 75, 67-74); they tell the scatter of the coefficients, Q2 what the expansion
/// misses.
[[nodiscard]] ChaosIndices polynomial_chaos(const Eigen::MatrixXd& places, const std::vector<int>& values,
                                            const Eigen::VectorXd& y, std::uint64_t seed);

}  // namespace cpt::parameters

// Dependence between inputs: a Gaussian copula given by rank correlations.
#pragma once

#include <Eigen/Core>

namespace cpt::parameters {

/// Pearson's correlation of normal scores whose rank correlation (Spearman's) is this: 2 sin(pi rho / 6)
/// (Pearson 1907, On further methods of determining correlation); and the other way.
[[nodiscard]] double score_correlation(double rank_correlation);
[[nodiscard]] double rank_correlation(double score_correlation);

/// Whether the matrix, symmetric with ones on its diagonal, is a correlation that a copula can have: its
/// least eigenvalue is at least 1e-8.
[[nodiscard]] bool positive_definite(const Eigen::MatrixXd& correlation);

/// The correlation matrix nearest to it in the Frobenius norm with eigenvalues of at least 1e-8: alternating
/// projections (Higham 2002, IMA J. Numer. Anal. 22, 329), scaled back to ones on the diagonal.
[[nodiscard]] Eigen::MatrixXd nearest_correlation(const Eigen::MatrixXd& matrix);

/// Places of runs in the unit cube (runs x inputs) with this correlation of their normal scores, from
/// independent ones: u = Phi(L z), z = Phi^-1(place), L L^T = correlation. An input that depends on none
/// before it keeps its places. Places of 0 and 1, whose scores are infinite, count as 1e-12 inside; NaN stays
/// NaN.
[[nodiscard]] Eigen::MatrixXd dependent_places(const Eigen::MatrixXd& places,
                                               const Eigen::MatrixXd& score_correlation);

}  // namespace cpt::parameters

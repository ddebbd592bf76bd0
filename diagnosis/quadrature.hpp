// Gauss-Legendre quadrature on boxes, and sums of numbers known by their logarithms.
#pragma once

#include <Eigen/Dense>

namespace cpt::diagnosis {

/// Nodes and weights of an average over an interval or a box; the weights add up to 1.
struct Quadrature {
  Eigen::MatrixXd nodes;    // points x dimensions
  Eigen::VectorXd weights;  // points
};

/// The rule on [0, 1] with `points` >= 1 nodes, exact to degree 2 points - 1 (Newton's method on the Legendre
/// polynomial).
[[nodiscard]] Quadrature gauss_legendre(int points);

/// The tensor product of that rule over the box [lower, upper], for the average over the box. The first
/// coordinate runs fastest.
[[nodiscard]] Quadrature box_rule(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, int points);

/// ln of the sum of exp(x); -infinity for none.
[[nodiscard]] double log_sum_exp(const Eigen::VectorXd& x);

}  // namespace cpt::diagnosis

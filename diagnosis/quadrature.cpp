#include "diagnosis/quadrature.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace cpt::diagnosis {

Quadrature gauss_legendre(int points) {
  Quadrature rule{Eigen::MatrixXd(points, 1), Eigen::VectorXd(points)};
  for (int i = 0; i < points; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (points + 0.5));
    double slope = 1.0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      double before = 0.0, here = 1.0;  // P_{k-1}, P_k
      for (int k = 0; k < points; ++k) {
        const double next = ((2.0 * k + 1.0) * x * here - k * before) / (k + 1.0);
        before = here;
        here = next;
      }
      slope = points * (x * here - before) / (x * x - 1.0);
      const double step = here / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    rule.nodes(i, 0) = 0.5 * (1.0 + x);
    rule.weights(i) = 1.0 / ((1.0 - x * x) * slope * slope);
  }
  rule.weights /= rule.weights.sum();
  return rule;
}

Quadrature box_rule(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, int points) {
  const Quadrature line = gauss_legendre(points);
  const Eigen::Index dimensions = lower.size();
  Eigen::Index count = 1;
  for (Eigen::Index d = 0; d < dimensions; ++d) count *= points;
  Quadrature rule{Eigen::MatrixXd(count, dimensions), Eigen::VectorXd::Ones(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::Index rest = i;
    for (Eigen::Index d = 0; d < dimensions; ++d, rest /= points) {
      const Eigen::Index node = rest % points;
      rule.nodes(i, d) = lower(d) + (upper(d) - lower(d)) * line.nodes(node, 0);
      rule.weights(i) *= line.weights(node);
    }
  }
  return rule;
}

double log_sum_exp(const Eigen::VectorXd& x) {
  if (x.size() == 0) return -std::numeric_limits<double>::infinity();
  const double largest = x.maxCoeff();
  if (!std::isfinite(largest)) return largest;
  return largest + std::log((x.array() - largest).exp().sum());
}

}  // namespace cpt::diagnosis

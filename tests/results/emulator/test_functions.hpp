// Functions of the unit cube that emulators are tried on, and points in it.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "parameters/designs/latin_hypercube.hpp"

namespace cpt::results {

using Function = std::function<double(const Eigen::RowVectorXd&)>;

/// Ishigami & Homma (1990): sin x1 + 7 sin^2 x2 + 0.1 x3^4 sin x1 over [-pi, pi]^3.
inline double ishigami(const Eigen::RowVectorXd& u) {
  const Eigen::Array3d x = std::numbers::pi * (2.0 * u.transpose().array() - 1.0);
  return std::sin(x(0)) + 7.0 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

/// Water that flows through a borehole [m3/year], eight inputs (Morris, Mitchell & Ylvisaker 1993).
inline double borehole(const Eigen::RowVectorXd& u) {
  const auto between = [&](Eigen::Index i, double a, double b) { return a + (b - a) * u(i); };
  const double rw = between(0, 0.05, 0.15), r = between(1, 100.0, 50000.0),
               tu = between(2, 63070.0, 115600.0), hu = between(3, 990.0, 1110.0),
               tl = between(4, 63.1, 116.0), hl = between(5, 700.0, 820.0), l = between(6, 1120.0, 1680.0),
               kw = between(7, 9855.0, 12045.0);
  const double log_ratio = std::log(r / rw);
  return 2.0 * std::numbers::pi * tu * (hu - hl) /
         (log_ratio * (1.0 + 2.0 * l * tu / (log_ratio * rw * rw * kw) + tu / tl));
}

inline Eigen::VectorXd values(const Function& function, const Eigen::MatrixXd& points) {
  Eigen::VectorXd y(points.rows());
  for (Eigen::Index i = 0; i < y.size(); ++i) y(i) = function(points.row(i));
  return y;
}

inline Eigen::MatrixXd hypercube(int inputs, int runs, std::uint64_t seed) {
  return parameters::latin_hypercube_places(inputs, runs, seed);
}

}  // namespace cpt::results

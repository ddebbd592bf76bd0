// Functions of the unit cube that emulators are tried on, and points in it.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>
#include <functional>

#include "parameters/designs/latin_hypercube.hpp"
#include "tests/parameters/designs/functions.hpp"

namespace cpt::results {

using Function = std::function<double(const Eigen::RowVectorXd&)>;

inline double ishigami(const Eigen::RowVectorXd& u) { return parameters::ishigami(u.transpose()); }
inline double borehole(const Eigen::RowVectorXd& u) { return parameters::borehole(u.transpose()); }

inline Eigen::VectorXd values(const Function& function, const Eigen::MatrixXd& points) {
  Eigen::VectorXd y(points.rows());
  for (Eigen::Index i = 0; i < y.size(); ++i) y(i) = function(points.row(i));
  return y;
}

inline Eigen::MatrixXd hypercube(int inputs, int runs, std::uint64_t seed) {
  return parameters::latin_hypercube_places(inputs, runs, seed);
}

}  // namespace cpt::results

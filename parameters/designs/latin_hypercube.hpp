// Latin hypercube (McKay, Beckman & Conover 1979, Technometrics 21, 239-245): runs that fill the box evenly
// in every single parameter. What they say is read by polynomial_chaos.hpp.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace cpt::parameters {

/// Runs x parameters: each column has one place in each of `runs` equal intervals of [0, 1], at random within
/// it and in random order. The same seed gives the same.
[[nodiscard]] Eigen::MatrixXd latin_hypercube_places(int parameters, int runs, std::uint64_t seed);

}  // namespace cpt::parameters

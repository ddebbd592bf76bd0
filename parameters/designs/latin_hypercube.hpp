// Latin hypercube (McKay, Beckman & Conover 1979, Technometrics 21, 239-245): runs that fill the box evenly
// in every single parameter. What they say is read by polynomial_chaos.hpp.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// Runs x parameters: each column has one place in each of `runs` equal intervals of [0, 1], at random within
/// it and in random order. The same seed gives the same.
[[nodiscard]] Eigen::MatrixXd latin_hypercube_places(int parameters, int runs, std::uint64_t seed);

/// The sample of `first_runs`, grown to `runs` one by one: each column is cut into as many equal intervals as
/// there are runs with the new one; this one goes to intervals that are empty, at random within them, and of
/// some such places to the one that leaves the sample with the least discrepancy. What is added first does
/// not depend on `runs`: a sample grown in two steps is that grown in one.
[[nodiscard]] Eigen::MatrixXd grown_latin_hypercube_places(int parameters, int first_runs, int runs,
                                                           std::uint64_t seed);

[[nodiscard]] DesignKind latin_hypercube_design();

}  // namespace cpt::parameters

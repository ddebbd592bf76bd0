// Elementary effects (Morris 1991, "Factorial sampling plans for preliminary computational experiments",
// Technometrics 33, 161-174): which parameters matter, and which of them not in proportion or not alone?
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "parameters/designs/bootstrap.hpp"
#include "parameters/designs/kind.hpp"

namespace cpt::parameters {

/// Trajectories through the grid {0, 1/(levels - 1), ..., 1} of the unit cube, each of parameters + 1 runs
/// that follow one another: from a random place every parameter in random order takes one step of
/// levels / (2 (levels - 1)) to the other half (Morris 1991). `levels` is even. Runs x parameters;
/// the same seed gives the same.
[[nodiscard]] Eigen::MatrixXd morris_places(int parameters, int trajectories, int levels, std::uint64_t seed);

/// Of one parameter, in the output's unit per width of the unit cube, which is the way from lower to upper.
struct ElementaryEffects {
  Estimate mu;       ///< mean
  Estimate mu_star;  ///< mean size (Campolongo, Cariboni & Saltelli 2007, Env. Modelling & Software 22)
  Estimate sigma;    ///< standard deviation: 0 where the effect is linear and does not depend on the others
  int used = 0;      ///< elementary effects
  int dropped = 0;   ///< elementary effects that touch a run without a result
};

/// The elementary effects of every parameter. `places` is runs x parameters as morris_places orders them,
/// whose steps may have been changed (a choice steps from 0 to 1, a whole number to the nearest); `y` has the
/// runs' results, NaN where there is none. A step that changes the result by rounding has no effect; all are
/// undefined where the result does not vary (variation.hpp). Intervals of mu and mu_star: bootstrap over the
/// trajectories that have an effect; of sigma, from five effects on: Bonett (2006), Computational Statistics
/// & Data Analysis 50, 775-782.
[[nodiscard]] std::vector<ElementaryEffects> elementary_effects(const Eigen::MatrixXd& places,
                                                                const Eigen::VectorXd& y, std::uint64_t seed);

[[nodiscard]] DesignKind morris_design();

}  // namespace cpt::parameters

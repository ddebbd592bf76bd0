// The posterior of one parameter of a mechanism, from the nodes of its evidence.
#pragma once

#include <vector>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// Density over phi; the prior's is 1.
struct Marginal {
  std::vector<double> phi;
  std::vector<double> density;
};

/// Of parameter k. Nodes that are no Gauss-Legendre grid give an empty one.
[[nodiscard]] Marginal marginal(const diagnosis::MechanismEvidence& evidence, Index k);

}  // namespace cpt::reports::diagnosed

// What a name that is no quantity may have been meant to be.
#pragma once

#include <string>
#include <string_view>

#include "solver/setup.hpp"

namespace cpt::parameters {

/// "did you mean sand.H?", or the laws that have such a parameter with the setup's soils of each, or "" where
/// nothing is near. Soils that no layer has are left out where it is known of which the layers are.
[[nodiscard]] std::string meant_quantity(std::string_view name, const solver::Setup& setup,
                                         bool layers_known = true);

}  // namespace cpt::parameters

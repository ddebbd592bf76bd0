// What is really pushed into what: the setup with the refinement and those mechanisms carried out that only
// change its inputs.
#pragma once

#include "solver/setup.hpp"

namespace cpt::solver {

/// Cushion transfer, overconsolidation, shifted layers, the worn cone and the refinement of the mesh
/// (refinement.hpp) become plain inputs and are switched off; all else stays. The same setup, bit for bit,
/// where they are off.
[[nodiscard]] Setup actual_setup(const Setup& setup);

}  // namespace cpt::solver

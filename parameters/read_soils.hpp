// The section [soils] of a study: soils by name, each of a law, in place of those that every study has.
#pragma once

#include "parameters/document.hpp"
#include "parameters/fields.hpp"
#include "solver/setup.hpp"

namespace cpt::parameters {

/// Puts the named soils, with the defaults of their laws, in place of the setup's. False where the section
/// has an error; true, and the setup as it was, without one.
[[nodiscard]] bool read_soils(const Value& root, solver::Setup& setup, ErrorList& errors);

/// Whether there are quantities "NAME.x" that are no soil's, such as those of the chamber.
[[nodiscard]] bool is_group_beside_soils(std::string_view name);

}  // namespace cpt::parameters

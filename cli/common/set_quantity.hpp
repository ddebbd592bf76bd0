// NAME=VALUE on the command line.
#pragma once

#include <string_view>

#include "solver/setup.hpp"

namespace cpt::cli {

/// Sets one quantity, in its study unit or by the name of a choice. Only names that start with `group`
/// ("sand.") are allowed. Throws BadInput that names value, range and the nearest valid name.
void set_quantity(solver::Setup& setup, std::string_view setting, std::string_view group);

}  // namespace cpt::cli

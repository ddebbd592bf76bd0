// All keys of a study file.
#pragma once

#include "parameters/keys.hpp"

namespace cpt::parameters {

/// The tables of a study, the top of the file first. Quantities, which [fixed], [parameters] and [[points]]
/// name, have a list of their own (solver/quantities.hpp); the keys of [parameters] are those of one row.
[[nodiscard]] std::span<const KeyTable> study_keys();

}  // namespace cpt::parameters

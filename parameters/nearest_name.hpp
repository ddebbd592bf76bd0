// Hints for misspelt names.
#pragma once

#include <span>
#include <string_view>

#include "solver/setup.hpp"

namespace cpt::parameters {

/// The quantity nearest to a misspelt one: a name without its group or unit, or with another unit, counts as
/// near. "" if none is near.
[[nodiscard]] std::string_view nearest_quantity(std::string_view name);
[[nodiscard]] std::string_view nearest_quantity(std::string_view name, const solver::Setup& setup);
/// The same among any names, by edit distance; part of a name counts as near.
[[nodiscard]] std::string_view nearest_name(std::string_view name, std::span<const std::string_view> names);

}  // namespace cpt::parameters

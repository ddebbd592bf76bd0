// The catalogue of mechanisms: `campaign list mechanisms`, the list of quantities and the diagnosis read it.
#pragma once

#include <span>
#include <string_view>

#include "solver/mechanisms/mechanism.hpp"

namespace cpt::solver {

[[nodiscard]] std::span<const Mechanism> all_mechanisms();
[[nodiscard]] const Mechanism* find_mechanism(std::string_view name);  ///< nullptr if there is none
/// True for a quantity of a mechanism: "surface_compaction.increase_percent".
[[nodiscard]] bool is_mechanism_parameter(std::string_view quantity);
/// True if the mechanism can act on these layers.
[[nodiscard]] bool applies(const Mechanism& mechanism, const Setup& setup);
/// True if some parameter differs from its default.
[[nodiscard]] bool is_on(const Mechanism& mechanism, const Setup& setup);

}  // namespace cpt::solver

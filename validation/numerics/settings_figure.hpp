// q_c against every numerical setting of a study.
#pragma once

#include <string>

#include "validation/numerics/study.hpp"

namespace cpt::validation::numerics {

/// One panel a setting: how far the average q_c in each window is from the repeats', over the setting; dashed
/// what the repeats explain. The cell size begins at zero, where the value that the three finest meshes
/// extrapolate to stands if their observed order makes sense. Wants settings.
[[nodiscard]] std::string settings_figure(const NumericsStudy& study);

}  // namespace cpt::validation::numerics

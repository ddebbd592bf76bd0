// The page of the numerical uncertainty as Markdown.
#pragma once

#include <string>
#include <vector>

#include "validation/numerics/study.hpp"

namespace cpt::validation::numerics {

/// Baselines of all presets, then each study of the numerics: its findings in sentences, repeats, every
/// setting and mesh in tables, and its figure FIGURES/NAME.svg.
[[nodiscard]] std::string page(const std::vector<NumericsStudy>& studies, const std::string& figures);

}  // namespace cpt::validation::numerics

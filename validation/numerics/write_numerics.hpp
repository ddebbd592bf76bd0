// Studies of the numerics as one page with figures.
#pragma once

#include <filesystem>
#include <vector>

#include "validation/numerics/study.hpp"

namespace cpt::validation::numerics {

/// Writes the page NAME.md and its figures (SVG and PNG) to the folder NAME beside it. Studies that change no
/// numerical setting only stand in the table of presets. Returns the files, the page first. Throws
/// results::Error if one cannot be written.
std::vector<std::filesystem::path> write_numerics(const std::vector<NumericsStudy>& studies,
                                                  const std::filesystem::path& page);

}  // namespace cpt::validation::numerics

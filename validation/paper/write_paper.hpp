// The comparison with the paper: page and figures.
#pragma once

#include <filesystem>
#include <vector>

#include "validation/paper/causes.hpp"
#include "validation/paper/pushes.hpp"

namespace cpt::validation::paper {

/// Writes the page NAME.md and its figures (SVG and PNG) to the folder NAME beside it, one folder a study and
/// `soil` and `chamber` for those that belong to none. With `beside`, other runs' numbers stand in columns of
/// their own, without figures. Returns the files, the page first. Throws results::Error if one cannot be
/// written.
std::vector<std::filesystem::path> write_paper(const Runs& runs, const std::vector<Cause>& causes,
                                               const std::filesystem::path& page,
                                               const Runs* beside = nullptr);

}  // namespace cpt::validation::paper

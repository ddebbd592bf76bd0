// The figure of a recording: what was measured over depth, and what is read out of it.
#pragma once

#include <string>

#include "recordings/interpretation.hpp"

namespace cpt::cli {

/// An SVG document.
[[nodiscard]] std::string recording_plot(const recordings::Recording& recording,
                                         const recordings::Interpretation& interpretation);

}  // namespace cpt::cli

// Layers that the model cannot tell from their neighbours.
//
// Every interface lies where it was asked for (point_grid.hpp), however thin the layer. But a layer lower
// than a cell around the tip shares its nodes with the soil above and below, and moves much as they do.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// Why an interval of depth [m] is too thin, "" where it is not: "the clay from 0.06 to 0.064 m, 4 mm thick,
/// is lower than a cell around the tip, 6.33 mm: ...".
[[nodiscard]] std::string too_thin(const Setup& setup, double top, double bottom, std::string_view what);

/// What is not made as asked though the run is possible, in one sentence each; empty where all is.
[[nodiscard]] std::vector<std::string> layer_remarks(const Setup& setup);

}  // namespace cpt::solver

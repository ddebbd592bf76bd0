// One factor for the whole mesh, one for the material points in its cells, and the scale of the penetrometer.
#pragma once

#include "solver/setup.hpp"

namespace cpt::solver {

/// The numerics of a setup with its scale, `refinement` and `point_density` carried out and the latter set to
/// one; the same settings, bit for bit, where all are one. The scale is the penetrometer's diameter over
/// `for_diameter`: cells, zones and spacings grow with it, so that a cone of 35.7 or 43.7 mm is as well
/// resolved as the reference. Zones keep their extent and the mesh its grading: with refinement r, r columns
/// stand where one stood, so that each is wider than its inner neighbour by the r-th root of the growth, and
/// numbers of rows, columns and points are rounded to whole ones (systematic refinement: Roache 1994, J.
/// Fluids Eng. 116, 405). Points get closer alike in both directions and keep their number in a cell, which
/// the density then multiplies.
[[nodiscard]] Numerics refined(const Setup& setup);

}  // namespace cpt::solver

// One factor for the whole mesh and one for the material points in its cells.
#pragma once

#include "solver/setup.hpp"

namespace cpt::solver {

/// Carries `refinement` and `point_density` out and sets them to one; the same settings, bit for bit, where
/// both are one. Zones keep their extent and the mesh its grading: with refinement r, r columns stand where
/// one stood, so that each is wider than its inner neighbour by the r-th root of the growth, and numbers of
/// rows, columns and points are rounded to whole ones (systematic refinement: Roache 1994, J. Fluids Eng.
/// 116, 405). Points get closer alike in both directions and keep their number in a cell, which the density
/// then multiplies.
[[nodiscard]] Numerics refined(Numerics numerics);

}  // namespace cpt::solver

// Where material points lie before the push: regular grids in radial zones.
#pragma once

#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// The points of one zone over the whole height of soil and surcharge, the penetrometer's place included.
struct PointGrid {
  double inner, outer;  // [m] radii of the zone
  int columns, rows;    // [-]
  double bottom;        // [m] height of the soil's bottom above its top, negative
  double dr, dz;        // [m] spacing
  double shift;         // [-] of the positions within their own cell of the grid, which keeps its outline

  [[nodiscard]] double r(int column) const { return inner + (column + 0.5 + 0.5 * shift) * dr; }
  [[nodiscard]] double z(int row) const { return bottom + (row + 0.5 + 0.5 * shift) * dz; }
};

/// The zones of a setup whose numerics are refined, cut or stretched to the chamber's wall, columns scaled to
/// keep their spacing.
[[nodiscard]] std::vector<PointGrid> point_grids(const Setup& setup);

}  // namespace cpt::solver

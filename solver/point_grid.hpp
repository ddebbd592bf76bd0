// Where material points lie before the push: regular grids in radial zones, in bands of height.
#pragma once

#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// The rows of one zone between two heights at which the soil changes.
struct PointBand {
  double bottom;  // [m] height above the soil's top
  int rows;       // [-]
  double dz;      // [m] spacing
};

/// The points of one zone over the whole height of soil and surcharge, the penetrometer's place included.
struct PointGrid {
  double inner, outer;  // [m] radii of the zone
  int columns;          // [-]
  double dr;            // [m] spacing
  double shift;         // [-] of the positions within their own cell of the grid, which keeps its outline
  std::vector<PointBand> bands;  // from the bottom upward

  [[nodiscard]] double r(int column) const { return inner + (column + 0.5 + 0.5 * shift) * dr; }
  [[nodiscard]] double z(const PointBand& band, int row) const {
    return band.bottom + (row + 0.5 + 0.5 * shift) * band.dz;
  }
};

/// The zones of a setup as it really is (actual_setup.hpp), cut or stretched to the chamber's wall, columns
/// scaled to keep their spacing. Bands begin at the soil's top, at each interface and at the edges of a
/// density lens, so that each is where it was asked for in every zone; rows are as many as asked for, or the
/// next more.
[[nodiscard]] std::vector<PointGrid> point_grids(const Setup& setup);

}  // namespace cpt::solver

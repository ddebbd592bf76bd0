// Where material points lie before the push: regular grids in radial zones, in bands of height.
#pragma once

#include <cstdint>
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
  double inner, outer;           // [m] radii of the zone
  int columns;                   // [-]
  double dr;                     // [m] spacing
  std::vector<PointBand> bands;  // from the bottom upward

  [[nodiscard]] double r(int column) const { return inner + (column + 0.5) * dr; }
  [[nodiscard]] double z(const PointBand& band, int row) const { return band.bottom + (row + 0.5) * band.dz; }
};

/// Farthest that a point may lie from its place on the grid, over the spacing [-]: as no cell is lower
/// than 1.2 spacings, none is without points.
inline constexpr double farthest_off = 0.1;

/// Where a point lies in its own cell of the grid, from the centre and over the spacing.
struct Scatter {
  double r, z;  // [-]
};
/// Every shift draws another, so that runs at different shifts are independent samples of where the points
/// may lie.
[[nodiscard]] Scatter scatter(double shift, std::uint64_t id);

/// The zones of a setup as it really is (actual_setup.hpp), cut or stretched to the chamber's wall, columns
/// scaled to keep their spacing. Bands begin at the soil's top, at each interface and at the edges of a
/// density lens, so that each is where it was asked for in every zone; rows are as many as asked for, or the
/// next more.
[[nodiscard]] std::vector<PointGrid> point_grids(const Setup& setup);

}  // namespace cpt::solver

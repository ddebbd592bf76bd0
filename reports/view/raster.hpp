// Material points to pixels.
//
// Each pixel shows the average of the points about it, weighted with a Gaussian of the point's own size (a
// Shepard interpolation, as in Monaghan (2005), "Smoothed particle hydrodynamics", section 2), so that points
// of zones of different spacing, and of soil that has stretched, fill the picture evenly. Only points of the
// material that has the largest weight in the pixel count: soil boundaries stay sharp.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "solver/material_points.hpp"

namespace cpt::reports::view {

/// Material points as they are drawn; one entry a point in each list.
struct DrawnPoints {
  std::vector<double> r, depth;       ///< [m] from the axis; below the soil's top
  std::vector<double> size;           ///< [m] side of the square in the r-z plane that the point stands for
  std::vector<std::size_t> material;  ///< number of its soil; after the last the surcharge
  std::size_t soils = 0;              ///< how many there are
  std::vector<std::vector<double>> fields;  ///< one list a field; NaN for materials that do not have it
};

/// What a picture shows: the soil from the axis to `radius`, between two depths. [m]
struct Window {
  double radius, top, bottom;
  bool operator==(const Window&) const = default;
};

class Raster {
 public:
  /// Wants columns, rows >= 1 and a window with an extent.
  Raster(const DrawnPoints& points, const Window& window, int columns, int rows);

  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] int rows() const { return rows_; }
  /// What fills the pixel; nothing where no point is near.
  [[nodiscard]] std::optional<std::size_t> material(int column, int row) const;
  /// Average of a field; NaN where there is no point or its material does not have the field.
  [[nodiscard]] double value(std::size_t field, int column, int row) const;
  /// The two soils that weigh most in the pixel, the lower number first; nothing where there is but one.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> soils(int column, int row) const;
  /// 1 in the first of two soils, -1 in the second, between them where both are near; NaN where neither is.
  [[nodiscard]] double first_or_second(std::pair<std::size_t, std::size_t> soils, int column, int row) const;

 private:
  [[nodiscard]] std::size_t pixel(int column, int row) const {
    return static_cast<std::size_t>(row) * columns_ + column;
  }
  [[nodiscard]] float weight(std::size_t material, std::size_t at) const {
    return sums_[material * (fields_ + 1)][at];
  }

  int columns_, rows_;
  std::size_t fields_, soils_;
  std::vector<std::vector<float>> sums_;  // material by material: the weights, then each field times weight
};

}  // namespace cpt::reports::view

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/view/frame.hpp"

namespace cpt::reports::view {
namespace {

constexpr Colour empty = Colour::of(0xffffff);
constexpr Colour grid_line = Colour::of(0x4a4a4a);
constexpr Colour boundary_core = Colour::of(0xffffff), boundary_edge = Colour::of(0x222222);

// How much of a pixel a line covers whose centre is so far away [pixels].
double covered(double away, double width) { return std::clamp(0.5 * width + 0.5 - away, 0.0, 1.0); }

// A number that varies over the picture, and how fast, from the pixel and its neighbours to the right and
// below.
struct Slope {
  double value, per_pixel;
};
template <typename Field>
Slope slope(const Field& field, const Raster& raster, int column, int row) {
  const double here = field(column, row);
  const double right = field(std::min(column + 1, raster.columns() - 1), row);
  const double below = field(column, std::min(row + 1, raster.rows() - 1));
  return {here, std::hypot(right - here, below - here)};
}

// Cover of the lines where `position` is a multiple of `spacing`; they fade where they run together.
double grid_cover(const Slope& position, double spacing) {
  const double lines = position.value / spacing, per_pixel = position.per_pixel / spacing;
  if (!(per_pixel > 0.0) || per_pixel > 0.25) return 0.0;
  return covered(std::abs(lines - std::round(lines)) / per_pixel, 1.0) * std::min(1.0, 2.0 - 8.0 * per_pixel);
}

// How far the pixel is from where two soils meet [pixels]; infinite within one.
double from_boundary(const Raster& raster, int column, int row) {
  constexpr double far_away = std::numeric_limits<double>::infinity();
  const auto pair = raster.soils(column, row);
  if (!pair) return far_away;
  const auto side = [&](int c, int r) { return raster.first_or_second(*pair, c, r); };
  const Slope soil = slope(side, raster, column, row);
  return std::abs(soil.value) < 0.98 && soil.per_pixel > 0.0 ? std::abs(soil.value) / soil.per_pixel
                                                             : far_away;
}

}  // namespace

drawing::Picture panel_picture(const View& view, std::size_t panel, const Raster& raster,
                               const Window& window) {
  const ColourScale& scale = view.panels[panel].scale;
  const bool gridded = view.grid > 0.0 && view.panels[panel].quantity->name == "displacement";
  const std::size_t u_r = view.panels.size(), u_depth = u_r + 1;
  const double across = window.radius / raster.columns();
  const double down = (window.bottom - window.top) / raster.rows();
  // Where the soil of a pixel was at the start.
  const auto start_r = [&](int c, int r) { return (c + 0.5) * across - raster.value(u_r, c, r); };
  const auto start_depth = [&](int c, int r) {
    return window.top + (r + 0.5) * down - raster.value(u_depth, c, r);
  };
  const std::size_t surcharge = view.geometry.soils;

  drawing::Picture picture{raster.columns(), raster.rows(), {}};
  picture.pixels.reserve(static_cast<std::size_t>(picture.width) * picture.height);
  for (int row = 0; row < picture.height; ++row)
    for (int column = 0; column < picture.width; ++column) {
      const auto material = raster.material(column, row);
      Colour colour = empty;
      if (material == surcharge) colour = no_value;
      if (material && material != surcharge) {
        colour = scale(raster.value(panel, column, row));
        if (gridded) {
          const double cover = std::max(grid_cover(slope(start_r, raster, column, row), view.grid),
                                        grid_cover(slope(start_depth, raster, column, row), view.grid));
          colour = mixed(colour, grid_line, 0.7 * cover);
        }
        if (const double away = from_boundary(raster, column, row); std::isfinite(away)) {
          colour = mixed(colour, boundary_edge, covered(away, 2.6));
          colour = mixed(colour, boundary_core, covered(away, 1.0));
        }
      }
      picture.pixels.push_back(colour.value());
    }
  return picture;
}

}  // namespace cpt::reports::view

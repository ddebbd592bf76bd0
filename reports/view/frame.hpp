// One frame of a view: fields around the cone at one depth of the tip, beside the profile of q_c.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/png.hpp"
#include "drawing/svg.hpp"
#include "reports/view/raster.hpp"
#include "reports/view/view_quantity.hpp"
#include "results/ledger/snapshot.hpp"
#include "results/push/stored_push.hpp"

namespace cpt::reports::view {

/// Penetrometer and chamber of a push. [m]
struct Geometry {
  double cone_radius, cone_height, sleeve_length;
  double chamber_radius, soil_height;
  bool flexible_wall;
  std::vector<results::LayerRow> layers;
  std::size_t soils;  ///< of the setup, also those that no layer has
};
/// Throws results::Error where the push's histories do not tell.
[[nodiscard]] Geometry geometry_of(const results::StoredPush& push);

/// The soil within `radius` [m] of the axis, from 0.8 of it above the tip to 1.2 of it below; without a
/// radius, the whole chamber.
[[nodiscard]] Window window_at(const Geometry& geometry, std::optional<double> radius, double tip_depth);

struct Panel {
  const ViewQuantity* quantity;
  ColourScale scale;  ///< in the quantity's unit
};

/// What all frames of a view have in common.
struct View {
  std::string title, subtitle;
  Geometry geometry;
  solver::DepthProfile profile;
  std::optional<double> radius;  ///< [m] of the soil that is shown; nothing: the whole chamber
  std::vector<Panel> panels;     ///< one or more
  double grid = 0.0;             ///< [m] side of the squares drawn on the undeformed soil; 0: none
  int width = 1000;              ///< [pixels]
};

/// Where everything of a frame is, in points; the boxes of the panels begin and end at whole pixels.
struct Layout {
  static constexpr double margin = 12.0;  ///< beside the words
  double width, height;
  double pixels_per_point;
  drawing::Box strip;                ///< of the profile of q_c
  std::vector<drawing::Box> panels;  ///< of equal size
  int columns, rows;                 ///< [pixels] of a panel
};
[[nodiscard]] Layout layout_of(const View& view);

/// The points of one depth, drawn with the panels' quantities as fields in their units, and the displacement
/// [m] in r and downward as the last two.
[[nodiscard]] DrawnPoints drawn_points(const View& view, const results::VtkPoints& points);

/// The pixels of a panel: shades, white where nothing is, the boundary of sand and clay, and on a panel of
/// the displacement the deformed grid.
[[nodiscard]] drawing::Picture panel_picture(const View& view, std::size_t panel, const Raster& raster,
                                             const Window& window);

/// The whole frame as SVG; render it with 72 * pixels_per_point dots per inch.
[[nodiscard]] std::string frame(const View& view, const Layout& layout, double tip_depth,
                                const DrawnPoints& points);

}  // namespace cpt::reports::view

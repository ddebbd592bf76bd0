// Layers as they are really made.
//
// A layer is made of whole rows of material points, which lie in radial zones of different spacing
// (point_grid): a row belongs to the layer that its middle lies in. So each interface is where the nearest
// face between two rows is, up to half a spacing off, the thickness is a multiple of the spacing, up to one
// spacing off, and both change from zone to zone. A layer lower than a cell around the tip moves as its
// neighbours do whatever it is made of, for they share its nodes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/setup.hpp"

namespace cpt::solver {

/// Deviations over the thickness asked for [-]: of the thickness made, or of the interface that is farther
/// off.
inline constexpr double layer_as_asked = 0.05;  ///< up to here nothing is said
inline constexpr double layer_not_made = 0.25;  ///< from here on a run is refused

/// A depth interval in one zone, asked for and made of rows.
struct MadeInterval {
  double inner, outer;           // [m] radii of the zone
  double spacing;                // [m] of its rows
  double top, bottom;            // [m] depths asked for
  double made_top, made_bottom;  // [m]

  [[nodiscard]] double asked() const { return bottom - top; }
  [[nodiscard]] double made() const { return made_bottom - made_top; }
  /// [-] over the thickness asked for
  [[nodiscard]] double deviation() const;
};

/// Each layer in each zone, interfaces shifted as the mechanisms say: by layer, from the axis outward. Empty
/// for one layer.
[[nodiscard]] std::vector<MadeInterval> made_layers(const Setup& setup);
/// The lens of density in each zone; empty where there is none.
[[nodiscard]] std::vector<MadeInterval> made_lens(const Setup& setup);

/// The least thickness [m] that is made within `deviation` wherever it lies, and the radius [m] outside which
/// the rows are that far apart.
struct LeastThickness {
  double thickness, outside;
};
[[nodiscard]] LeastThickness least_thickness(const Setup& setup, double deviation);

/// What is not made as asked, in one sentence each, worst zone first; empty where all is. Nothing of layers
/// that are not made at all: those are problems (quantities.hpp).
[[nodiscard]] std::vector<std::string> layer_remarks(const Setup& setup);

/// What is wrong with an interval that is not made, "" where it is: "the clay from 0.06 to 0.064 m, 4 mm
/// thick, would be 0 mm thick beyond r = 0.2 m: ...", with the least thickness that can be made.
[[nodiscard]] std::string not_made(const Setup& setup, const std::vector<MadeInterval>& zones,
                                   std::string_view what);

}  // namespace cpt::solver

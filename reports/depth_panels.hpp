// A measured sounding: several quantities side by side over one depth axis.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/text.hpp"

namespace cpt::reports {

struct DepthPanel {
  drawing::Rich title;
  std::vector<double> values;  ///< one for each depth; NaN breaks the curve
  std::string_view color;
  std::vector<double> beside = {};        ///< a second curve in the same unit, dashed; may be empty
  std::string_view beside_color = {};     ///< of the second
  std::vector<std::size_t> circled = {};  ///< values that a small circle points out
};

/// A depth interval in a column of its own.
struct DepthBand {
  double from, to;  // [m]
  std::string label;
  std::string_view color;
};

struct DepthPanels {
  std::string title;
  std::vector<std::string> lines;                               ///< below the title
  std::vector<double> depth;                                    // [m] not falling
  std::vector<DepthPanel> panels;                               ///< at least one
  double shaded_to = std::numeric_limits<double>::quiet_NaN();  // [m] grey from the top down to here
  std::vector<double> marks;                                    // [m] ticks at the right edge
  drawing::Rich bands_title = {};
  std::vector<DepthBand> bands = {};  ///< right of the panels; no column where there are none
  std::string note;                   ///< below the panels
};

/// The figure as an SVG document; scales from zero where all values are positive.
[[nodiscard]] std::string depth_panels(const DepthPanels& figure);

}  // namespace cpt::reports

// Curves over a linear or logarithmic axis, in a panel of a figure.
#pragma once

#include <string_view>
#include <vector>

#include "drawing/axis.hpp"
#include "drawing/svg.hpp"

namespace cpt::drawing {

struct XyCurve {
  std::vector<Point> points;  ///< data, not paper
  Pen pen;
  double mark = 0.0;  ///< radius on paper: circles of the pen's colour in place of a line
};

/// The area between two lines with as many points.
struct XyFill {
  std::vector<Point> below, above;  ///< data, not paper
  std::string_view color;
  double opacity = 1.0;
};

struct XyPlot {
  Rich x_title, y_title;
  std::vector<XyCurve> curves;
  bool log_x = false;   ///< wants x > 0; points at or below zero are left out
  bool y_down = false;  ///< the least y on top
  int x_ticks = 5, y_ticks = 5;
  std::vector<Point> room = {};    ///< data that the axes hold too
  std::vector<XyFill> fills = {};  ///< under the curves
};

/// Axes wide enough for all fills, curves and the room, then the curves.
void draw(Svg& svg, const Box& box, const XyPlot& plot);

}  // namespace cpt::drawing

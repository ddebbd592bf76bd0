// Curves over a linear or logarithmic axis, in a panel of a figure.
#pragma once

#include <vector>

#include "reports/axis.hpp"
#include "reports/svg.hpp"

namespace cpt::reports {

struct XyCurve {
  std::vector<Point> points;  ///< data, not paper
  Pen pen;
};

struct XyPlot {
  Rich x_title, y_title;
  std::vector<XyCurve> curves;
  bool log_x = false;   ///< wants x > 0; points at or below zero are left out
  bool y_down = false;  ///< the least y on top
  int x_ticks = 5, y_ticks = 5;
};

/// Axes wide enough for all curves, then the curves.
void draw(Svg& svg, const Box& box, const XyPlot& plot);

}  // namespace cpt::reports

#include "drawing/xy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/palette.hpp"

namespace cpt::drawing {
namespace {

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// Grid lines at every digit of a decade, labels at its start. `axis` is of log10.
void draw_logarithmic(Svg& svg, const Box& box, const Axis& axis, const Rich& title) {
  const double y = box.bottom();
  for (int decade = static_cast<int>(std::floor(axis.low)); decade <= axis.high; ++decade)
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = decade + std::log10(digit);
      if (value < axis.low - 1e-9 || value > axis.high + 1e-9) continue;
      const double x = axis(value);
      svg.line({x, box.y}, {x, y}, {palette::grid, digit == 1 ? 0.7 : 0.25, {}});
      if (digit != 1) continue;
      svg.line({x, y}, {x, y + 3.0}, {palette::ink, 0.6, {}});
      svg.text({x, y + 12.2}, plain(fmt::format("{:g}", std::pow(10.0, decade))),
               {.size = 7.5, .anchor = Anchor::middle});
    }
  svg.text({box.x + 0.5 * box.width, y + 26.0}, title, {.size = 8.5, .anchor = Anchor::middle});
}

}  // namespace

void draw(Svg& svg, const Box& box, const XyPlot& plot) {
  const auto x_of = [&](const Point& point) {
    if (!plot.log_x) return point.x;
    return point.x > 0.0 ? std::log10(point.x) : std::numeric_limits<double>::quiet_NaN();
  };
  Extent x, y;
  const auto take = [&](const std::vector<Point>& points) {
    for (const Point& point : points) {
      if (!std::isfinite(x_of(point)) || !std::isfinite(point.y)) continue;
      x.take(x_of(point));
      y.take(point.y);
    }
  };
  for (const XyCurve& curve : plot.curves) take(curve.points);
  for (const XyFill& fill : plot.fills) take(fill.below), take(fill.above);
  take(plot.room);
  if (!(x.low <= x.high)) return;
  const bool marked = std::ranges::any_of(plot.curves, [](const XyCurve& c) { return c.mark > 0.0; });
  const Range across = widened(x.low, x.high, plot.log_x ? 0.02 : marked ? 0.03 : 0.0);
  const Range up = widened(y.low, y.high, 0.05);
  const Axis horizontal{across.low, across.high, box.x, box.right()};
  const Axis vertical =
      plot.y_down ? Axis{up.low, up.high, box.y, box.bottom()} : Axis{up.low, up.high, box.bottom(), box.y};
  if (plot.log_x)
    draw_logarithmic(svg, box, horizontal, plot.x_title);
  else
    draw_horizontal(svg, box, horizontal, Edge::bottom, plot.x_title, plot.x_ticks);
  draw_vertical(svg, box, vertical, plot.y_title, plot.y_ticks);

  svg.begin_clip(box);
  const auto on_paper = [&](const std::vector<Point>& data) {
    std::vector<Point> points;
    for (const Point& point : data) points.push_back({horizontal(x_of(point)), vertical(point.y)});
    return points;
  };
  for (const XyFill& fill : plot.fills) {
    std::vector<Point> around = on_paper(fill.below);
    const std::vector<Point> back = on_paper(fill.above);
    around.insert(around.end(), back.rbegin(), back.rend());
    svg.polygon(around, fill.color, fill.opacity);
  }
  for (const XyCurve& curve : plot.curves) {
    const std::vector<Point> points = on_paper(curve.points);
    if (curve.mark > 0.0)
      for (const Point& point : points)
        svg.circle(point, curve.mark, curve.pen.color, {palette::ink, 0.4, {}});
    else
      svg.polyline(points, curve.pen);
  }
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
}

}  // namespace cpt::drawing

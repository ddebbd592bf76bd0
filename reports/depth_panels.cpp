#include "reports/depth_panels.hpp"

#include <algorithm>
#include <cmath>

#include "drawing/axis.hpp"
#include "drawing/palette.hpp"
#include "drawing/svg.hpp"
#include "reports/labels.hpp"

namespace cpt::reports {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::Pen, drawing::plain,
    drawing::Point, drawing::Range, drawing::Svg, drawing::Tick, drawing::ticks, drawing::widened;
namespace palette = drawing::palette;

constexpr double left_margin = 50.0, right_margin = 14.0, panel_gap = 14.0;
constexpr double depth_panel_height = 400.0;
constexpr double least_panel_width = 116.0, least_figure_width = 300.0;
constexpr double bands_width = 30.0;
constexpr double line_height = 12.5;

Axis across(const DepthPanel& panel, const Box& box) {
  double low = 0.0, high = 0.0;
  for (const std::vector<double>* values : {&panel.values, &panel.beside})
    for (const double value : *values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  const Range range = widened(low, high, 0.05);
  return {low < 0.0 ? range.low : 0.0, range.high, box.x, box.right()};
}

void draw_panel(Svg& svg, const DepthPanels& figure, const DepthPanel& panel, const Box& box,
                const Axis& depth, bool first) {
  if (figure.shaded_to > depth.low)
    svg.rectangle({box.x, box.y, box.width, depth(std::min(figure.shaded_to, depth.high)) - box.y},
                  palette::band, 0.5);
  const Axis axis = across(panel, box);
  draw_horizontal(svg, box, axis, Edge::top, panel.title, 4);
  if (first)
    draw_vertical(svg, box, depth, plain("depth (m)"), 10);
  else
    for (const Tick& tick : ticks(depth.low, depth.high, 10))
      svg.line({box.x, depth(tick.value)}, {box.right(), depth(tick.value)}, {palette::grid, 0.4, {}});
  svg.begin_clip(box);
  const auto curve = [&](const std::vector<double>& values, const Pen& pen) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < values.size(); ++i)
      points.push_back({axis(values[i]), depth(figure.depth[i])});
    svg.polyline(points, pen);
  };
  curve(panel.values, {panel.color, 0.8, {}});
  if (!panel.beside.empty()) curve(panel.beside, {panel.beside_color, 0.7, "3 2"});
  for (const std::size_t i : panel.circled)
    svg.circle({axis(panel.values[i]), depth(figure.depth[i])}, 2.5, "none", {palette::ink, 0.7, {}});
  svg.end_clip();
  for (const double mark : figure.marks)
    svg.line({box.right() - 5.0, depth(mark)}, {box.right(), depth(mark)}, {palette::ink, 0.7, {}});
  svg.frame(box, {palette::ink, 0.6, {}});
}

void draw_bands(Svg& svg, const DepthPanels& figure, const Box& box, const Axis& depth) {
  constexpr double size = 7.0;
  for (const DepthBand& band : figure.bands) {
    const double top = depth(std::max(band.from, depth.low)), bottom = depth(std::min(band.to, depth.high));
    if (bottom <= top) continue;
    svg.rectangle({box.x, top, box.width, bottom - top}, band.color, 0.6);
    if (bottom - top > size)
      svg.text({box.x + 0.5 * box.width, 0.5 * (top + bottom) + 0.35 * size}, plain(band.label),
               {.size = size, .anchor = Anchor::middle});
  }
  svg.text({box.x + 0.5 * box.width, box.y - 7.0}, figure.bands_title,
           {.size = 7.5, .anchor = Anchor::middle});
  svg.frame(box, {palette::ink, 0.6, {}});
}

}  // namespace

std::string depth_panels(const DepthPanels& figure) {
  const auto count = static_cast<double>(figure.panels.size());
  const double bands = figure.bands.empty() ? 0.0 : panel_gap + bands_width;
  const double beside = left_margin + (count - 1.0) * panel_gap + bands + right_margin;
  const double width = std::max(least_figure_width, beside + count * least_panel_width);
  const double panel_width = (width - beside) / count;
  const double top = 23.0 + line_height * static_cast<double>(figure.lines.size()) + 36.0;
  Svg svg(width, top + depth_panel_height + 26.0, "recording");
  const double room = width - 20.0;
  double y = 17.0;
  svg.text({10.0, y}, plain(shortened(figure.title, room, 10.0, true)), {.size = 10.0, .bold = true});
  for (const std::string& line : figure.lines)
    svg.text({10.0, y += line_height}, plain(shortened(line, room, 8.0)),
             {.size = 8.0, .color = palette::muted});
  const double shallowest = figure.depth.empty() ? 0.0 : figure.depth.front();
  const double deepest = figure.depth.empty() ? 1.0 : figure.depth.back();
  const double surface = shallowest > 0.0 && shallowest < 0.05 * deepest ? 0.0 : shallowest;
  const Range down = deepest > surface ? Range{surface, deepest} : widened(surface, deepest, 0.0);
  const Axis depth{down.low, down.high, top, top + depth_panel_height};
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    draw_panel(svg, figure, figure.panels[i],
               {left_margin + static_cast<double>(i) * (panel_width + panel_gap), top, panel_width,
                depth_panel_height},
               depth, i == 0);
  if (!figure.bands.empty())
    draw_bands(svg, figure, {width - right_margin - bands_width, top, bands_width, depth_panel_height},
               depth);
  svg.text({10.0, top + depth_panel_height + 16.0}, plain(shortened(figure.note, room, 7.0)),
           {.size = 7.0, .color = palette::muted});
  return svg.document(figure.title);
}

}  // namespace cpt::reports

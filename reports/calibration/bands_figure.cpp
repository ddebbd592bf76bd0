#include <algorithm>
#include <cmath>
#include <vector>

#include "drawing/axis.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/calibration/figures.hpp"
#include "reports/calibration/panel_grid.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::calibrated {
namespace {

using diagnosis::CalibratedBand;
using drawing::Axis, drawing::Box, drawing::Edge, drawing::Pen, drawing::plain, drawing::Point, drawing::Rich,
    drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

constexpr std::string_view run_fill = "#f7dcc8";  // of simulated runs

// Bands of one channel in one sounding.
struct BandPanels {
  std::string symbol, sounding;
  std::vector<CalibratedBand> bands;
};

std::vector<BandPanels> panels_of(const CalibrationReport& report) {
  std::vector<BandPanels> found;
  for (std::size_t c = 0; c < report.channels.size(); ++c)
    for (std::size_t s = 0; s < report.soundings.size(); ++s) {
      BandPanels panels{
          report.channels[c].symbol, report.soundings.size() > 1 ? report.soundings[s] : "", {}};
      for (const CalibratedBand& band : report.posterior.bands[c])
        if (band.cell.sounding == static_cast<int>(s)) panels.bands.push_back(band);
      if (!panels.bands.empty()) found.push_back(std::move(panels));
    }
  return found;
}

template <class Value>
std::vector<Point> over_depth(const BandPanels& panels, const Axis& across, const Axis& down,
                              const Value& value) {
  std::vector<Point> points;
  for (const CalibratedBand& band : panels.bands)
    points.push_back({across(value(band)), down(band.cell.depth)});
  return points;
}

template <class Lower, class Upper>
void draw_band(Svg& svg, const BandPanels& panels, const Axis& across, const Axis& down, const Lower& lower,
               const Upper& upper, std::string_view fill) {
  std::vector<Point> corners = over_depth(panels, across, down, lower);
  std::vector<Point> back = over_depth(panels, across, down, upper);
  corners.insert(corners.end(), back.rbegin(), back.rend());
  svg.polygon(corners, fill);
}

Axis depth_axis(const BandPanels& panels, const Box& box) {
  const diagnosis::Cell &first = panels.bands.front().cell, &last = panels.bands.back().cell;
  return {first.depth - 0.5 * first.height, last.depth + 0.5 * last.height, box.y, box.bottom()};
}

void draw_values(Svg& svg, const Box& box, const BandPanels& panels) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const CalibratedBand& band : panels.bands) {
    low = std::min({low, band.predicted.lower, band.recorded});
    high = std::max({high, band.predicted.upper, band.recorded});
  }
  const drawing::Range range = drawing::widened(low, high, 0.05);
  const Axis across{range.low, range.high, box.x, box.right()}, down = depth_axis(panels, box);
  draw_horizontal(svg, box, across, Edge::bottom, symbolic(panels.symbol) + plain(" (kPa)"), 4);
  draw_vertical(svg, box, down, plain("depth (m)"), 6);
  svg.begin_clip(box);
  draw_band(
      svg, panels, across, down, [](const auto& b) { return b.predicted.lower; },
      [](const auto& b) { return b.predicted.upper; }, palette::band);
  draw_band(
      svg, panels, across, down, [](const auto& b) { return b.simulation.lower; },
      [](const auto& b) { return b.simulation.upper; }, run_fill);
  svg.polyline(over_depth(panels, across, down, [](const auto& b) { return b.simulation.median; }),
               {palette::vermillion, 1.2, {}});
  svg.polyline(over_depth(panels, across, down, [](const auto& b) { return b.recorded; }),
               {palette::ink, 1.0, {}});
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
  if (!panels.sounding.empty())
    svg.text({box.x, box.y - 5.0}, plain(shortened(panels.sounding, box.width, 8.0)), {.bold = true});
}

void draw_discrepancy(Svg& svg, const Box& box, const BandPanels& panels) {
  double most = 0.0;
  for (const CalibratedBand& band : panels.bands)
    most = std::max({most, std::abs(band.discrepancy.lower), std::abs(band.discrepancy.upper)});
  if (!(most > 0.0)) most = 1.0;
  const Axis across{-1.1 * most, 1.1 * most, box.x, box.right()}, down = depth_axis(panels, box);
  draw_horizontal(svg, box, across, Edge::bottom,
                  plain("discrepancy of ") + symbolic(panels.symbol) + plain(" (%)"), 4);
  draw_vertical(svg, box, down, plain(""), 6);
  svg.begin_clip(box);
  draw_band(
      svg, panels, across, down, [](const auto& b) { return b.discrepancy.lower; },
      [](const auto& b) { return b.discrepancy.upper; }, palette::sky);
  svg.line({across(0.0), box.y}, {across(0.0), box.bottom()}, {palette::ink, 0.8, "3 2"});
  svg.polyline(over_depth(panels, across, down, [](const auto& b) { return b.discrepancy.mean; }),
               {palette::blue, 1.2, {}});
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
}

}  // namespace

std::string bands_figure(const CalibrationReport& report) {
  const std::vector<BandPanels> all = panels_of(report);
  const PanelGrid grid{2 * all.size(), std::min<std::size_t>(4, 2 * all.size()), 52.0, 190.0};
  drawing::FlowLegend legend;
  legend.line(plain("recorded"), {palette::ink, 1.0, {}});
  legend.line(plain("simulated, median"), {palette::vermillion, 1.2, {}});
  legend.patch(plain("90 % of simulations"), run_fill);
  legend.patch(plain("90 % of other recordings there"), palette::band);
  legend.line(plain("discrepancy, mean"), {palette::blue, 1.2, {}});
  legend.patch(plain("its 90 % band"), palette::sky);
  const double room = grid.width() - 28.0;
  Svg svg(grid.width(), grid.bottom() + legend.height(room) + 4.0, "bands");
  for (std::size_t k = 0; k < all.size(); ++k) {
    draw_values(svg, grid.box(2 * k), all[k]);
    draw_discrepancy(svg, grid.box(2 * k + 1), all[k]);
  }
  draw_heading(svg, shortened(report.title, grid.width() - 16.0, 10.0, true),
               plain("the recording, runs with parameters of the posterior, and what is left between them"));
  legend.draw(svg, {14.0, grid.bottom()}, room);
  return svg.document("Recording and simulation: " + report.title);
}

}  // namespace cpt::reports::calibrated

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drawing/axis.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/calibration/figures.hpp"
#include "reports/calibration/panel_grid.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::calibrated {
namespace {

using drawing::Axis, drawing::Box, drawing::Edge, drawing::plain, drawing::Point, drawing::Svg;
using Eigen::Index;
using Eigen::VectorXd;
namespace palette = drawing::palette;

void draw_ranks(Svg& svg, const Box& box, const diagnosis::EcdfDifference& band, const VectorXd& difference,
                const std::string& name) {
  const double most =
      1.1 * std::max({band.upper.maxCoeff(), -band.lower.minCoeff(), difference.cwiseAbs().maxCoeff()});
  const Axis across{0.0, 1.0, box.x, box.right()}, up{-most, most, box.bottom(), box.y};
  draw_horizontal(svg, box, across, Edge::bottom, plain("rank, as a share"), 4);
  draw_vertical(svg, box, up, plain(""), 4);
  std::vector<Point> corners, back, curve;
  for (Index k = 0; k < band.at.size(); ++k) {
    corners.push_back({across(band.at(k)), up(band.lower(k))});
    back.push_back({across(band.at(k)), up(band.upper(k))});
    curve.push_back({across(band.at(k)), up(difference(k))});
  }
  corners.insert(corners.end(), back.rbegin(), back.rend());
  svg.begin_clip(box);
  svg.polygon(corners, palette::band);
  svg.line({box.x, up(0.0)}, {box.right(), up(0.0)}, {palette::muted, 0.7, "3 2"});
  svg.polyline(curve, {palette::blue, 1.2, {}});
  svg.end_clip();
  svg.frame(box, {palette::ink, 0.6, {}});
  svg.text({box.x, box.y - 5.0}, plain(shortened(name, box.width + 30.0, 8.0)), {.bold = true});
}

}  // namespace

std::string ranks_figure(const RankReport& report) {
  const diagnosis::RankCheck& check = report.check;
  const auto cases = static_cast<int>(check.cases.size());
  const diagnosis::EcdfDifference band = diagnosis::simultaneous_band(cases, check.draws, 0.95, report.seed);
  const PanelGrid grid{check.unknowns.size(), 3, 54.0};
  drawing::FlowLegend legend;
  legend.line(plain("ECDF of the ranks less the uniform one"), {palette::blue, 1.2, {}});
  legend.patch(plain("holds all of it with 95 %, were they uniform"), palette::band);
  Svg svg(grid.width(), grid.bottom() + 14.0, "ranks");
  for (std::size_t j = 0; j < check.unknowns.size(); ++j)
    draw_ranks(svg, grid.box(j), band,
               diagnosis::ecdf_difference(check.ranks.col(static_cast<Index>(j)), check.draws, band.at),
               check.unknowns[j]);
  draw_heading(
      svg, shortened(report.title, grid.width() - 16.0, 10.0, true),
      plain(fmt::format("ranks of the truth among {} draws of its posterior, over {} recordings made of runs "
                        "that the emulator has not seen",
                        check.draws, cases)));
  legend.draw(svg, {14.0, grid.bottom()}, grid.width() - 28.0);
  return svg.document("Simulation-based calibration: " + report.title);
}

}  // namespace cpt::reports::calibrated

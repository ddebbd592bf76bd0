#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"

namespace cpt::reports {
namespace {

using drawing::Box, drawing::FlowLegend, drawing::plain, drawing::Point, drawing::Rich, drawing::Svg,
    drawing::symbolic;
namespace palette = drawing::palette;

constexpr double plot_height_of_convergence = 150.0;

struct Line {
  std::string_view quantity, words, color, shade;
};
constexpr std::array<Line, 3> lines_of_convergence = {
    {{"mean", "mean", palette::ink, palette::band},
     {"quantile_05", "5 % quantile", palette::blue, palette::sky},
     {"quantile_95", "95 % quantile", palette::vermillion, palette::orange}}};

}  // namespace

std::optional<std::string> propagation_convergence_figure(const results::Snapshot& campaign,
                                                          const results::Effects& effects,
                                                          const results::WindowRow& window, Place place) {
  drawing::XyPlot plot;
  FlowLegend legend;
  std::size_t most_points = 0;
  for (const Line& line : lines_of_convergence) {
    drawing::XyCurve curve{{}, {line.color, 1.3, {}}};
    drawing::XyFill fill{{}, {}, line.shade, 0.4};
    for (const results::ConvergenceRow& row : effects.convergence) {
      if (row.window != window.name || row.quantity != line.quantity || !std::isfinite(row.estimate.value))
        continue;
      const auto x = static_cast<double>(row.runs);
      curve.points.push_back({x, row.estimate.value});
      if (!std::isfinite(row.estimate.lower)) continue;
      fill.below.push_back({x, row.estimate.lower});
      fill.above.push_back({x, row.estimate.upper});
    }
    most_points = std::max(most_points, curve.points.size());
    plot.fills.push_back(std::move(fill));
    plot.curves.push_back(std::move(curve));
    legend.line(plain(line.words), {line.color, 1.3, {}});
  }
  if (most_points < 2) return std::nullopt;
  plot.x_title = plain("runs");
  plot.y_title = axis_of(window);
  plot.x_ticks = place.column == drawing::Column::single ? 4 : 6;

  const double figure_width = width_of(place.column);
  const std::string where = place_of(campaign, window);
  const std::vector<Rich> heading = {
      window_line(window, plain(where.empty() ? "" : ": " + where), figure_width),
      plain("what the first runs said; shaded: 95 % interval")};
  const double room = figure_width - 28.0;
  Svg svg(figure_width,
          heading_height(campaign, heading.size(), place.ground) + plot_height_of_convergence + 58.0 +
              legend.height(room),
          "convergence", place.ground);
  const double top = draw_heading(svg, campaign, campaign.campaign.title, heading);
  const Box box{52.0, top + 6.0, figure_width - 52.0 - 16.0, plot_height_of_convergence};
  draw(svg, box, plot);
  legend.draw(svg, {14.0, box.bottom() + 44.0}, room);
  return svg.document(fmt::format("Convergence: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

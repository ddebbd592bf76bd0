#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"

namespace cpt::reports {
namespace {

using drawing::Box, drawing::FlowLegend, drawing::plain, drawing::Point, drawing::Rich, drawing::Svg,
    drawing::symbolic, drawing::XyFill;
namespace palette = drawing::palette;

using results::DepthBandRow;

constexpr double bands_height = 260.0;

XyFill between(const std::vector<const DepthBandRow*>& rows, std::size_t low, std::size_t high,
               std::string_view color) {
  XyFill fill{{}, {}, color, 1.0};
  for (const DepthBandRow* row : rows) {
    fill.below.push_back({row->quantiles[low].value, row->depth_m});
    fill.above.push_back({row->quantiles[high].value, row->depth_m});
  }
  return fill;
}

}  // namespace

std::optional<std::string> bands_figure(const results::Snapshot& campaign, const results::Effects& effects,
                                        const solver::Channel& channel, Place place) {
  std::vector<const DepthBandRow*> rows;
  for (const DepthBandRow& row : effects.bands)
    if (row.channel == channel.name && std::isfinite(row.quantiles.front().value)) rows.push_back(&row);
  if (rows.size() < 2) return std::nullopt;

  drawing::XyPlot plot;
  plot.fills = {between(rows, 0, 4, palette::band), between(rows, 1, 3, palette::faint)};
  drawing::XyCurve median{{}, {palette::blue, 1.3, {}}}, mean{{}, {palette::vermillion, 1.0, "3 2"}};
  for (const DepthBandRow* row : rows) {
    median.points.push_back({row->quantiles[2].value, row->depth_m});
    mean.points.push_back({row->mean.value, row->depth_m});
  }
  plot.curves = {median, mean};
  plot.room = {{0.0, 0.0}};
  plot.x_title = symbolic(fmt::format("{} (kPa)", channel.symbol));
  plot.y_title = plain("depth (m)");
  plot.y_down = true;
  plot.x_ticks = place.column == drawing::Column::single ? 4 : 6;

  FlowLegend legend;
  const auto patch = [&legend](std::string_view words, std::string_view color) {
    legend.add(12.0, plain(words), [color](Svg& svg, Point at) {
      svg.rectangle({at.x, at.y - 4.0, 12.0, 8.0}, color);
    });
  };
  legend.line(plain("median"), median.pen);
  legend.line(plain("mean"), mean.pen);
  patch("25 to 75 %", palette::faint);
  patch("5 to 95 %", palette::band);

  const int most = (*std::ranges::max_element(rows, {}, &DepthBandRow::runs))->runs;
  const double figure_width = width_of(place.column);
  std::vector<Rich> heading = {
      symbolic(fmt::format("{} with its inputs drawn from their distributions", channel.symbol)),
      plain(fmt::format("{} runs; each depth stands alone", most))};
  if (!effects.numerical_error.empty())
    heading.push_back(symbolic("with a numerical error of " + effects.numerical_error));
  const double room = figure_width - 28.0;
  Svg svg(figure_width,
          heading_height(campaign, heading.size(), place.ground) + bands_height + 58.0 + legend.height(room),
          "bands", place.ground);
  const double top = draw_heading(svg, campaign, campaign.campaign.title, heading);
  const Box box{52.0, top + 6.0, figure_width - 52.0 - 16.0, bands_height};
  draw(svg, box, plot);
  legend.draw(svg, {14.0, box.bottom() + 44.0}, room);
  return svg.document(fmt::format("Bands of {}: {}", channel.name, campaign.campaign.title));
}

}  // namespace cpt::reports

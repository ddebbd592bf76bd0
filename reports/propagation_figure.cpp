#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "drawing/xy_plot.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"

namespace cpt::reports {
namespace {

using drawing::Box, drawing::FlowLegend, drawing::number, drawing::plain, drawing::Point, drawing::Rich,
    drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;

using results::EffectRow;
using results::Effects;
using results::Snapshot;

constexpr double plot_height = 150.0;
constexpr double mark = 2.4;
constexpr std::array<std::pair<std::string_view, double>, 5> quantiles = {{{"quantile_05", 5.0},
                                                                           {"quantile_25", 25.0},
                                                                           {"quantile_50", 50.0},
                                                                           {"quantile_75", 75.0},
                                                                           {"quantile_95", 95.0}}};

// Averages of the design's runs in the window's unit, ascending.
std::vector<double> averages(const Snapshot& s, const Effects& effects, const std::string& window) {
  std::vector<double> found;
  for (const int run : effects.runs)
    for (const results::WindowMeanRow& mean : s.window_means)
      if (mean.realization == run && mean.window == window) found.push_back(mean.q_c_mean_kPa);
  std::ranges::sort(found);
  return found;
}

const EffectRow* row_of(const Effects& effects, const std::string& window, std::string_view quantity) {
  const auto found = std::ranges::find_if(effects.rows, [&](const EffectRow& row) {
    return row.window == window && row.quantity == quantity && std::isfinite(row.value);
  });
  return found == effects.rows.end() ? nullptr : &*found;
}

// Share of the runs [%] with an average of at most x.
std::vector<Point> steps(const std::vector<double>& sorted) {
  std::vector<Point> points;
  const double share = 100.0 / static_cast<double>(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    points.push_back({sorted[i], share * static_cast<double>(i)});
    points.push_back({sorted[i], share * static_cast<double>(i + 1)});
  }
  return points;
}

std::string with_interval(const EffectRow& row) {
  if (!std::isfinite(row.lower)) return number(row.value, 4);
  return fmt::format("{} ± {}", number(row.value, 4), number(row.upper - row.value, 2));
}

}  // namespace

std::optional<std::string> propagation_figure(const Snapshot& campaign, const Effects& effects,
                                              const results::WindowRow& window, Place place) {
  const std::vector<double> sorted = averages(campaign, effects, window.name);
  const EffectRow* mean = row_of(effects, window.name, "mean");
  const EffectRow* deviation = row_of(effects, window.name, "standard_deviation");
  if (sorted.size() < 2 || mean == nullptr || deviation == nullptr) return std::nullopt;

  const double figure_width = width_of(place.column);
  const std::string where = place_of(campaign, window), unit = unit_behind(window);
  std::vector<Rich> lines = {
      window_line(window, plain(where.empty() ? "" : ": " + where), figure_width),
      plain(fmt::format("{} runs: mean {}{}, standard deviation {}{} (95 %)", sorted.size(),
                        with_interval(*mean), unit, with_interval(*deviation), unit))};
  if (!effects.numerical_error.empty())
    lines.push_back(
        symbolic("quantiles and standard deviation with a numerical error of " + effects.numerical_error));
  FlowLegend legend;
  legend.line(plain("runs"), {palette::blue, 1.2, {}});
  legend.add(12.0, plain("5, 25, 50, 75, 95 % quantile, 95 % interval"), [](Svg& svg, Point at) {
    svg.line({at.x, at.y}, {at.x + 12.0, at.y}, {palette::vermillion, 1.0, {}});
    svg.circle({at.x + 6.0, at.y}, mark, palette::vermillion, {palette::ink, 0.5, {}});
  });

  drawing::XyPlot plot;
  plot.x_title = axis_of(window);
  plot.y_title = plain("share of the runs (%)");
  plot.x_ticks = place.column == drawing::Column::single ? 4 : 6;
  plot.room = {{sorted.front(), 0.0}, {sorted.back(), 100.0}};
  plot.curves.push_back({steps(sorted), {palette::blue, 1.2, {}}});
  for (const auto& [name, percent] : quantiles) {
    const EffectRow* row = row_of(effects, window.name, name);
    if (row == nullptr) continue;
    if (std::isfinite(row->lower))
      plot.curves.push_back({{{row->lower, percent}, {row->upper, percent}}, {palette::vermillion, 1.0, {}}});
    plot.curves.push_back({{{row->value, percent}}, {palette::vermillion, 1.1, {}}, mark});
  }

  const double heading = heading_height(campaign, lines.size(), place.ground);
  const double room = figure_width - 28.0;
  Svg svg(figure_width, heading + plot_height + 58.0 + legend.height(room), "propagation", place.ground);
  const double top = draw_heading(svg, campaign, campaign.campaign.title, lines);
  const Box box{52.0, top + 6.0, figure_width - 52.0 - 16.0, plot_height};
  draw(svg, box, plot);
  legend.draw(svg, {14.0, box.bottom() + 44.0}, room);
  return svg.document(fmt::format("Propagation: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
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

using results::EffectRow;
using results::Effects;
using results::Snapshot;

constexpr double convergence_height = 150.0;
constexpr double estimate_mark = 1.9;
constexpr std::size_t most_inputs = 6;  // that colours tell apart
constexpr double side_step = 0.006;     // of the axis: intervals of different inputs stand beside each other

/// The estimates of one input, from fewer runs to all.
using Steps = std::vector<EffectRow>;

// Inputs with the largest last estimate, in the design's order where these are equal.
std::vector<Steps> converging_inputs(const Effects& effects, const std::string& window) {
  std::vector<Steps> inputs;
  for (const EffectRow& row : effects.index_convergence) {
    if (row.window != window) continue;
    const auto same = [&](const Steps& steps) { return steps.front().parameter == row.parameter; };
    const auto found = std::ranges::find_if(inputs, same);
    if (found == inputs.end())
      inputs.push_back({row});
    else
      found->push_back(row);
  }
  std::ranges::stable_sort(inputs,
                           [](const Steps& a, const Steps& b) { return a.back().value > b.back().value; });
  if (inputs.size() > most_inputs) inputs.resize(most_inputs);
  return inputs;
}

Rich quantity_words(const EffectRow& row, const results::WindowRow& window) {
  return row.quantity == "mu_star" ? plain(window.is_scalar() ? "μ* of " : "μ* of the ") + axis_of(window)
                                   : plain("total order: share of the variance");
}

/// What is shown: all estimates and the last intervals. Those of a few runs may be many times as long.
struct Shown {
  double least = 0.0, most = 0.0;
};
Shown shown_of(const std::vector<Steps>& inputs) {
  constexpr double above = 1.5;
  Shown shown;
  const auto hold = [&](double value) {
    if (!std::isfinite(value)) return;
    shown.least = std::min(shown.least, value);
    shown.most = std::max(shown.most, value);
  };
  for (const Steps& steps : inputs) {
    for (const EffectRow& row : steps) hold(row.value);
    hold(steps.back().lower);
    hold(steps.back().upper);
  }
  shown.most *= above;
  return shown;
}

}  // namespace

std::optional<std::string> index_convergence_figure(const Snapshot& campaign, const Effects& effects,
                                                    const results::WindowRow& window, Place place) {
  const std::vector<Steps> inputs = converging_inputs(effects, window.name);
  if (std::ranges::none_of(inputs, [](const Steps& steps) { return steps.size() > 1; })) return std::nullopt;

  const double figure_width = width_of(place.column);
  int most_runs = 0;
  for (const Steps& steps : inputs) most_runs = std::max(most_runs, steps.back().runs);
  drawing::XyPlot plot;
  plot.x_title = plain("runs with results that were used");
  plot.y_title = quantity_words(inputs.front().front(), window);
  plot.x_ticks = place.column == drawing::Column::single ? 4 : 6;
  plot.room = {{0.0, 0.0}, {static_cast<double>(most_runs), 0.0}};
  const Shown shown = shown_of(inputs);
  FlowLegend legend;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const drawing::Pen pen{palette::series[k], 1.1, {}}, thin{palette::series[k], 0.7, {}};
    const double aside =
        side_step * most_runs * (static_cast<double>(k) - 0.5 * static_cast<double>(inputs.size() - 1));
    std::vector<Point> line;
    for (const EffectRow& row : inputs[k]) {
      const double x = row.runs + aside;
      line.push_back({x, row.value});
      if (std::isfinite(row.lower))
        plot.curves.push_back(
            {{{x, std::max(row.lower, shown.least)}, {x, std::min(row.upper, shown.most)}}, thin});
    }
    plot.curves.push_back({line, pen});
    plot.curves.push_back({line, pen, estimate_mark});
    legend.line(symbol_of(campaign, parameter_of(campaign, inputs[k].front().parameter)), pen);
  }

  const std::string where = place_of(campaign, window);
  const std::vector<Rich> lines = {
      window_line(window, plain(where.empty() ? "" : ": " + where), figure_width),
      plain("estimates from the design's first runs alone; lines: 95 % interval, cut off at the frame")};
  const double heading = heading_height(campaign, lines.size(), place.ground);
  const double room = figure_width - 28.0;
  Svg svg(figure_width, heading + convergence_height + 58.0 + legend.height(room), "convergence",
          place.ground);
  const double top = draw_heading(svg, campaign, campaign.campaign.title, lines);
  const Box box{52.0, top + 6.0, figure_width - 52.0 - 16.0, convergence_height};
  draw(svg, box, plot);
  legend.draw(svg, {14.0, box.bottom() + 44.0}, room);
  return svg.document(fmt::format("Convergence: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

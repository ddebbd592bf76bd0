#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/axis.hpp"
#include "reports/figures.hpp"
#include "reports/flow_legend.hpp"
#include "reports/labels.hpp"
#include "reports/palette.hpp"

namespace cpt::reports {
namespace {

using results::EffectRow;
using results::Effects;
using results::Snapshot;

constexpr double row_pitch = 15.5;
constexpr double bar_height = 9.5;
constexpr double value_size = 7.0;
constexpr double label_size = 8.5;
constexpr double value_room = 40.0;
constexpr std::size_t most_rows = 20;

/// What is drawn of a kind of design: a bar with its interval, and a circle.
struct Drawn {
  std::string_view bar, circle;  ///< quantities
  Rich axis, bar_words, circle_words;
};

Drawn drawn_of(std::string_view design) {
  if (design == "pairs")
    return {"interaction",
            "",
            symbolic("interaction in the average q_c (kPa)"),
            plain("interaction, its 95 % interval from the repeats"),
            {}};
  if (design == "morris")
    return {"mu_star", "sigma", symbolic("elementary effect on the average q_c, lower to upper bound (kPa)"),
            plain("mean size μ* with 95 % interval"), plain("standard deviation σ")};
  return {"total_order", "first_order", symbolic("share of the variance of the average q_c (–)"),
          plain("with all interactions (total order), 95 % interval"), plain("alone (first order)")};
}

/// A parameter, or a pair of them.
struct Bar {
  EffectRow row;
  double circle = NAN;
  Rich label;
};

std::vector<Bar> make_bars(const Snapshot& s, const Effects& effects, const Drawn& drawn,
                           const std::string& window) {
  std::vector<Bar> bars;
  for (const EffectRow& row : effects.rows) {
    if (row.window != window || row.quantity != drawn.bar) continue;
    Bar bar{row, NAN, symbol_of(s, parameter_of(s, row.parameter))};
    if (!row.other_parameter.empty())
      bar.label = bar.label + plain(" × ") + symbol_of(s, parameter_of(s, row.other_parameter));
    for (const EffectRow& other : effects.rows)
      if (other.window == window && other.quantity == drawn.circle && other.parameter == row.parameter)
        bar.circle = other.value;
    bars.push_back(std::move(bar));
  }
  const auto size = [](const Bar& bar) {
    return std::isfinite(bar.row.value) ? std::abs(bar.row.value) : -1.0;
  };
  std::stable_sort(bars.begin(), bars.end(), [&](const Bar& a, const Bar& b) { return size(a) > size(b); });
  if (bars.size() > most_rows) bars.resize(most_rows);
  return bars;
}

Axis make_axis(const std::vector<Bar>& bars, const Box& plot) {
  double low = 0.0, high = 0.0;
  for (const Bar& bar : bars)
    for (const double value : {bar.row.value, bar.row.lower, bar.row.upper, bar.circle})
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low == high) high = 1.0;
  const double margin = low < 0.0 ? 4.0 : 0.0;
  const double per_point = (high - low) / (plot.width - value_room - margin);
  return {low - margin * per_point, high + value_room * per_point, plot.x, plot.right()};
}

void draw_whisker(Svg& svg, double from, double to, double y) {
  const Pen pen{palette::ink, 0.9, {}};
  svg.line({from, y}, {to, y}, pen);
  for (const double x : {from, to}) svg.line({x, y - 2.2}, {x, y + 2.2}, pen);
}

void draw_circle(Svg& svg, double x, double y) {
  svg.circle({x, y}, 2.4, "#ffffff", {palette::vermillion, 1.1, {}});
}

void draw_bar(Svg& svg, const Axis& axis, const Bar& bar, double y) {
  const EffectRow& row = bar.row;
  const double base = y + 0.36 * value_size, zero = axis(0.0);
  if (!std::isfinite(row.value)) {
    svg.text({zero + 4.0, base}, plain(shortened("× " + row.note, axis.to - zero - 8.0, value_size)),
             {.size = value_size, .color = palette::vermillion, .halo = true});
    return;
  }
  const double x = axis(row.value);
  svg.rectangle({std::min(zero, x), y - 0.5 * bar_height, std::abs(x - zero), bar_height},
                row.value < 0.0 ? palette::orange : palette::blue, 0.8);
  double end = std::max(zero, x);
  if (std::isfinite(row.lower)) {
    draw_whisker(svg, axis(row.lower), axis(row.upper), y);
    end = std::max(end, axis(row.upper));
  }
  if (std::isfinite(bar.circle)) {
    draw_circle(svg, axis(bar.circle), y);
    end = std::max(end, axis(bar.circle) + 2.4);
  }
  const std::string text = row.unit == "-" ? decimals(row.value, 3) : number(row.value, 3);
  svg.text({end + 3.0, base}, plain(text), {.size = value_size, .halo = true});
}

/// What the reader must know: how well the fit is, what is missing.
std::string remark(const Effects& effects, const std::string& window, const std::vector<Bar>& bars) {
  std::string text;
  for (const EffectRow& row : effects.rows)
    if (row.window == window && row.quantity == "Q2" && std::isfinite(row.value))
      text = fmt::format("polynomial chaos, Q2 = {}", decimals(row.value, 3));
  const std::string& note = bars.front().row.note;
  return text + (text.empty() || note.empty() ? "" : "; ") + note;
}

FlowLegend make_legend(const Drawn& drawn) {
  FlowLegend legend;
  legend.add(18.0, drawn.bar_words, [](Svg& svg, Point at) {
    svg.rectangle({at.x, at.y - 3.5, 12.0, 7.0}, palette::blue, 0.8);
    draw_whisker(svg, at.x + 6.0, at.x + 18.0, at.y);
  });
  if (!drawn.circle.empty())
    legend.add(6.0, drawn.circle_words, [](Svg& svg, Point at) { draw_circle(svg, at.x + 3.0, at.y); });
  return legend;
}

}  // namespace

std::optional<std::string> effects_figure(const Snapshot& campaign, const Effects& effects,
                                          const results::WindowRow& window, Column column) {
  const double figure_width = width_of(column);
  const Drawn drawn = drawn_of(effects.design);
  const std::vector<Bar> bars = make_bars(campaign, effects, drawn, window.name);
  if (bars.empty() || !std::isfinite(bars.front().row.value)) return std::nullopt;

  double label_width = 0.0;
  for (const Bar& bar : bars) label_width = std::max(label_width, width(bar.label, label_size));
  const double room = figure_width - 28.0;
  std::vector<Rich> lines = {window_line(
      window, plain(fmt::format(": design {}, {}", effects.design, depth_range(window.from_m, window.to_m))),
      figure_width)};
  if (const std::string text = remark(effects, window.name, bars); !text.empty())
    lines.push_back(plain(shortened(text, room, 8.0)));
  const double plot_height = row_pitch * static_cast<double>(bars.size()) + 4.0;
  const double heading =
      23.0 + 12.5 * (static_cast<double>(lines.size()) + (all_completed(campaign) ? 0.0 : 1.0));
  const FlowLegend legend = make_legend(drawn);
  Svg svg(figure_width, heading + 4.0 + plot_height + 50.0 + legend.height(room), "effects");
  const double top = draw_heading(svg, campaign, campaign.campaign.title, lines);
  const double left = 14.0 + label_width + 8.0;
  const Box plot{left, top + 4.0, figure_width - 14.0 - left, plot_height};
  const Axis axis = make_axis(bars, plot);

  draw_horizontal(svg, plot, axis, Edge::bottom, drawn.axis, column == Column::single ? 4 : 6);
  double y = plot.y + 2.0 + 0.5 * row_pitch;
  for (const Bar& bar : bars) {
    svg.text({plot.x - 8.0, y + 0.34 * label_size}, bar.label, {.size = label_size, .anchor = Anchor::end});
    draw_bar(svg, axis, bar, y);
    y += row_pitch;
  }
  svg.line({axis(0.0), plot.y}, {axis(0.0), plot.bottom()}, {palette::ink, 0.6, {}});
  svg.line({plot.x, plot.bottom()}, {plot.right(), plot.bottom()}, {palette::ink, 0.6, {}});

  legend.draw(svg, {14.0, plot.bottom() + 46.0}, room);
  return svg.document(fmt::format("Effects: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

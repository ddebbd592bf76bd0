#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/axis.hpp"
#include "drawing/bar_rows.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"

namespace cpt::reports {
namespace {

using drawing::Axis, drawing::Box, drawing::Column, drawing::decimals, drawing::Edge, drawing::FlowLegend,
    drawing::number, drawing::plain, drawing::Point, drawing::Rich, drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;
namespace bar_rows = drawing::bar_rows;

using results::EffectRow;
using results::Effects;
using results::Snapshot;

constexpr double effect_value_room = 40.0;
constexpr std::size_t most_rows = 20;

/// What is drawn of a kind of design: a bar with its interval, and a circle.
struct Drawn {
  std::string_view bar, circle;  ///< quantities
  Rich axis, bar_words, circle_words;
  std::string_view words;
};

Drawn drawn_of(std::string_view design, const Rich& average, const Rich& axis) {
  if (design == "pairs")
    return {"interaction",
            "",
            plain("interaction in ") + axis,
            plain("interaction, its 95 % interval from the repeats"),
            {},
            "Bars: interaction of two inputs; lines: 95 % interval from the repeats."};
  if (design == "morris")
    return {
        "mu_star",
        "sigma",
        plain("elementary effect on ") + axis,
        plain("mean size μ* from lower to upper bound, 95 % interval"),
        plain("standard deviation σ"),
        "Bars: mean size μ* of the elementary effects, from lower to upper bound, with its 95 % interval; "
        "circles: their standard deviation σ, large where the effect is not linear or depends on other "
        "inputs."};
  if (design == "propagation")
    return {
        "shapley",
        "first_order",
        plain("share of the variance of ") + average + plain(" (–)"),
        plain("Shapley effect, 95 % interval"),
        plain("taken off the variance where the input is known (first order)"),
        "Bars: Shapley effect, the share of the variance that an input accounts for, with its 95 % interval; "
        "all add up to one, correlated or not. Circles: what knowing the input alone takes off the variance, "
        "with all that goes along with it (first order)."};
  return {"total_order",
          "first_order",
          plain("share of the variance of ") + average + plain(" (–)"),
          plain("with all interactions (total order), 95 % interval"),
          plain("alone (first order)"),
          "Bars: share of the variance with all interactions (total order) and its 95 % interval; circles: "
          "alone (first order)."};
}

/// A parameter, or a pair of them.
struct EffectBar {
  EffectRow row;
  EffectRow circle;  ///< its value NaN where there is none
  Rich label;
};

std::vector<EffectBar> effect_bars(const Snapshot& s, const Effects& effects, const Drawn& drawn,
                                   const std::string& window) {
  std::vector<EffectBar> bars;
  for (const EffectRow& row : effects.rows) {
    if (row.window != window || row.quantity != drawn.bar) continue;
    EffectBar bar{row, {}, symbol_of(s, parameter_of(s, row.parameter))};
    bar.circle.value = NAN;
    if (!row.other_parameter.empty())
      bar.label = bar.label + plain(" × ") + symbol_of(s, parameter_of(s, row.other_parameter));
    for (const EffectRow& other : effects.rows)
      if (other.window == window && other.quantity == drawn.circle && other.parameter == row.parameter)
        bar.circle = other;
    bars.push_back(std::move(bar));
  }
  const auto size = [](const EffectBar& bar) {
    return std::isfinite(bar.row.value) ? std::abs(bar.row.value) : -1.0;
  };
  std::stable_sort(bars.begin(), bars.end(),
                   [&](const EffectBar& a, const EffectBar& b) { return size(a) > size(b); });
  if (bars.size() > most_rows) bars.resize(most_rows);
  return bars;
}

Axis effects_axis(const std::vector<EffectBar>& bars, const Box& plot) {
  double low = 0.0, high = 0.0;
  for (const EffectBar& bar : bars)
    for (const double value : {bar.row.value, bar.row.lower, bar.row.upper, bar.circle.value})
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low == high) high = 1.0;
  const double margin = low < 0.0 ? 4.0 : 0.0;
  const double per_point = (high - low) / (plot.width - effect_value_room - margin);
  return {low - margin * per_point, high + effect_value_room * per_point, plot.x, plot.right()};
}

void draw_circle(Svg& svg, double x, double y) {
  svg.circle({x, y}, 2.4, palette::paper, {palette::vermillion, 1.1, {}});
}

void draw_effect(Svg& svg, const Axis& axis, const EffectBar& bar, double y) {
  const EffectRow& row = bar.row;
  const double base = y + 0.36 * bar_rows::value_size, zero = axis(0.0);
  if (!std::isfinite(row.value)) {
    svg.text({zero + 4.0, base},
             plain(shortened("× " + row.note, axis.to - zero - 8.0, bar_rows::value_size)),
             {.size = bar_rows::value_size, .color = palette::warn, .halo = true});
    return;
  }
  const double x = axis(row.value);
  svg.rectangle({std::min(zero, x), y - 0.5 * bar_rows::bar_height, std::abs(x - zero), bar_rows::bar_height},
                row.value < 0.0 ? palette::orange : palette::blue, 0.8);
  double end = std::max(zero, x);
  if (std::isfinite(row.lower)) {
    bar_rows::draw_whisker(svg, axis(row.lower), axis(row.upper), y);
    end = std::max(end, axis(row.upper));
  }
  const std::string text = row.unit == "-" ? decimals(row.value, 3) : number(row.value, 3);
  if (std::isfinite(bar.circle.value)) {
    const double circle = axis(bar.circle.value), room = 10.0 + width(plain(text), bar_rows::value_size);
    draw_circle(svg, circle, y);
    if (circle < end + room) end = std::max(end, circle + 2.4);  // else the number stands before it
  }
  svg.text({end + 3.0, base}, plain(text), {.size = bar_rows::value_size, .halo = true});
}

/// The numbers of a bar, a line each.
std::string words_of_bar(const EffectBar& bar) {
  const EffectRow& row = bar.row;
  const std::string unit = row.unit == "-" ? "" : " " + row.unit;
  std::string words =
      fmt::format("{}\n{}: {}{}", words_of(bar.label), row.quantity, number(row.value, 4), unit);
  if (std::isfinite(row.lower))
    words += fmt::format("\n95 %: {} to {}{}", number(row.lower, 4), number(row.upper, 4), unit);
  if (std::isfinite(bar.circle.value))
    words += fmt::format("\n{}: {}{}", bar.circle.quantity, number(bar.circle.value, 4), unit);
  return row.note.empty() ? words : words + "\n" + row.note;
}

/// What the reader must know: how well the fit is, what is missing.
std::string remark(const Effects& effects, const std::string& window, const std::vector<EffectBar>& bars) {
  std::string text;
  for (const EffectRow& row : effects.rows)
    if (row.window == window && row.quantity == "Q2" && std::isfinite(row.value))
      text = fmt::format("{}, Q2 = {}",
                         effects.design == "propagation" ? "sparse polynomial" : "polynomial chaos",
                         decimals(row.value, 3));
  const std::string& note = bars.front().row.note;
  return text + (text.empty() || note.empty() ? "" : "; ") + note;
}

FlowLegend effects_legend(const Drawn& drawn) {
  FlowLegend legend;
  legend.add(18.0, drawn.bar_words, [](Svg& svg, Point at) {
    svg.rectangle({at.x, at.y - 3.5, 12.0, 7.0}, palette::blue, 0.8);
    bar_rows::draw_whisker(svg, at.x + 6.0, at.x + 18.0, at.y);
  });
  if (!drawn.circle.empty())
    legend.add(6.0, drawn.circle_words, [](Svg& svg, Point at) { draw_circle(svg, at.x + 3.0, at.y); });
  return legend;
}

}  // namespace

std::string effects_legend_words(std::string_view design) {
  return std::string(drawn_of(design, {}, {}).words);
}

std::optional<std::string> effects_figure(const Snapshot& campaign, const Effects& effects,
                                          const results::WindowRow& window, Place place) {
  const double figure_width = width_of(place.column);
  const std::string where = place_of(campaign, window);
  const Rich the = plain(window.is_scalar() ? "" : "the ");
  const Drawn drawn = drawn_of(effects.design, the + average_of(window), the + axis_of(window));
  const std::vector<EffectBar> bars = effect_bars(campaign, effects, drawn, window.name);
  if (bars.empty() || !std::isfinite(bars.front().row.value)) return std::nullopt;

  double label_width = 0.0;
  for (const EffectBar& bar : bars)
    label_width = std::max(label_width, width(bar.label, bar_rows::label_size));
  const double room = figure_width - 28.0;
  std::vector<Rich> lines = {window_line(
      window, plain(fmt::format(": design {}{}{}", effects.design, where.empty() ? "" : ", ", where)),
      figure_width)};
  if (const std::string text = remark(effects, window.name, bars); !text.empty())
    lines.push_back(plain(shortened(text, room, 8.0)));
  const double plot_height = bar_rows::pitch * static_cast<double>(bars.size()) + 4.0;
  const double heading = heading_height(campaign, lines.size(), place.ground);
  const FlowLegend legend = effects_legend(drawn);
  Svg svg(figure_width, heading + 4.0 + plot_height + 50.0 + legend.height(room), "effects", place.ground);
  const double top = draw_heading(svg, campaign, campaign.campaign.title, lines);
  const double left = 14.0 + label_width + 8.0;
  const Box plot{left, top + 4.0, figure_width - 14.0 - left, plot_height};
  const Axis axis = effects_axis(bars, plot);

  draw_horizontal(svg, plot, axis, Edge::bottom, drawn.axis, place.column == Column::single ? 4 : 6);
  double y = plot.y + 2.0 + 0.5 * bar_rows::pitch;
  for (const EffectBar& bar : bars) {
    svg.begin_part(bar_rows::row(svg, y), words_of_bar(bar));
    bar_rows::draw_label(svg, plot, y, bar.label);
    draw_effect(svg, axis, bar, y);
    svg.end_part();
    y += bar_rows::pitch;
  }
  svg.line({axis(0.0), plot.y}, {axis(0.0), plot.bottom()}, {palette::ink, 0.6, {}});
  svg.line({plot.x, plot.bottom()}, {plot.right(), plot.bottom()}, {palette::ink, 0.6, {}});

  legend.draw(svg, {14.0, plot.bottom() + 46.0}, room);
  return svg.document(fmt::format("Effects: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

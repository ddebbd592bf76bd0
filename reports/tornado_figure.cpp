#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/axis.hpp"
#include "drawing/bar_rows.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/notes.hpp"

namespace cpt::reports {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Column, drawing::Edge, drawing::FlowLegend,
    drawing::number, drawing::plain, drawing::Point, drawing::Range, drawing::Rich, drawing::Svg,
    drawing::symbolic, drawing::widened;
namespace palette = drawing::palette;
namespace bar_rows = drawing::bar_rows;

using results::SensitivityRow;
using results::Snapshot;

constexpr double value_gap = 3.0;

struct TornadoBar {
  SensitivityRow row;
  Rich label;
  std::string lower_text, upper_text;
  std::string missing;  // what to say instead of the bound that has no result
  bool waits;           // and only because its runs are still to come
};

std::string absent(const Snapshot& campaign, const SensitivityRow& row, std::string_view side, double q,
                   const std::string& value_text) {
  const results::RealizationRow* run = bound_run(campaign, row.parameter, side);
  if (std::isfinite(q) || run == nullptr) return "";
  return fmt::format("{}: {}", value_text,
                     run->waiting()     ? "not run yet"
                     : run->completed() ? "no value"
                                        : run->status);
}

std::vector<TornadoBar> tornado_bars(const Snapshot& campaign, const std::string& window) {
  std::vector<TornadoBar> bars;
  for (const SensitivityRow& row : sensitivity_in(campaign, window)) {
    const results::ParameterRow& p = parameter_of(campaign, row.parameter);
    const std::string low = absent(campaign, row, "lower", row.q_lower_kPa, p.lower_text);
    const std::string high = absent(campaign, row, "upper", row.q_upper_kPa, p.upper_text);
    bars.push_back({row, symbol_of(campaign, p) + unit_of(p), p.lower_text, p.upper_text,
                    low.empty() || high.empty() ? low + high : low + ", " + high, to_come(campaign, row)});
  }
  const auto swing = [](const TornadoBar& bar) {
    const double q = std::abs(bar.row.q_upper_kPa - bar.row.q_lower_kPa);
    return std::isfinite(q) ? q : -1.0;
  };
  std::stable_sort(bars.begin(), bars.end(),
                   [&](const TornadoBar& a, const TornadoBar& b) { return swing(a) > swing(b); });
  return bars;
}

/// q range of all bars, and the room that the texts at their ends want on either side.
Axis tornado_axis(const std::vector<TornadoBar>& bars, double q_baseline, double from, double to) {
  double low = q_baseline;
  double high = q_baseline;
  double room = 0.0;
  for (const TornadoBar& bar : bars) {
    for (const double q : {bar.row.q_lower_kPa, bar.row.q_upper_kPa}) {
      if (!std::isfinite(q)) continue;
      low = std::min(low, q);
      high = std::max(high, q);
    }
    room = std::max({room, width(plain(bar.lower_text), bar_rows::value_size),
                     width(plain(bar.upper_text), bar_rows::value_size)});
  }
  const Range range = widened(low, high, 0.0);
  room = std::min(room + 2.0 * value_gap + 2.0, 0.3 * (to - from));
  const double per_point = (range.high - range.low) / (to - from - 2.0 * room);
  return {range.low - room * per_point, range.high + room * per_point, from, to};
}

void draw_swing(Svg& svg, const Axis& axis, const TornadoBar& bar, double y, double q_baseline) {
  const double x0 = axis(q_baseline);
  const auto at = [&](double q) { return std::isfinite(q) ? axis(q) : x0; };
  const double lower = at(bar.row.q_lower_kPa);
  const double upper = at(bar.row.q_upper_kPa);
  const double left = std::min(lower, upper);
  const double right = std::max(lower, upper);
  // Each half has its bound's colour; they meet at the baseline, or halfway where the baseline lies outside.
  const double meet = x0 >= left && x0 <= right ? x0 : 0.5 * (left + right);
  const auto part = [&](double end, std::string_view color) {
    svg.rectangle(
        {std::min(end, meet), y - 0.5 * bar_rows::bar_height, std::abs(end - meet), bar_rows::bar_height},
        color);
  };
  part(lower, palette::blue);
  part(upper, palette::vermillion);
  if (meet != x0) {
    const double near = x0 < left ? left : right;
    svg.line({x0, y}, {near, y}, {palette::ink, 0.5, "1.5 1.5"});
  }
  const double base = y + 0.36 * bar_rows::value_size;
  const bool rising = upper >= lower;
  const bool has_lower = std::isfinite(bar.row.q_lower_kPa);
  const bool has_upper = std::isfinite(bar.row.q_upper_kPa);
  double clear_right = right + value_gap;
  double clear_left = left - value_gap;
  const auto put = [&](bool present, const std::string& text, bool on_left) {
    if (!present) return;
    svg.text({on_left ? left - value_gap : right + value_gap, base}, plain(text),
             {.size = bar_rows::value_size, .anchor = on_left ? Anchor::end : Anchor::start, .halo = true});
    const double taken = width(plain(text), bar_rows::value_size) + 2.0 * value_gap;
    on_left ? clear_left -= taken : clear_right += taken;
  };
  put(has_lower, bar.lower_text, rising);
  put(has_upper, bar.upper_text, !rising);
  if (bar.missing.empty()) return;
  const Rich note = plain(bar.waits ? bar.missing : "× " + bar.missing);
  const bool fits = clear_right + width(note, bar_rows::value_size) < axis.to;
  svg.text({fits ? clear_right : clear_left, base}, note,
           {.size = bar_rows::value_size,
            .anchor = fits ? Anchor::start : Anchor::end,
            .color = bar.waits ? palette::muted : palette::warn,
            .halo = true});
}

FlowLegend tornado_legend(bool noise) {
  FlowLegend legend;
  bar_rows::add_patch(legend, plain("to the lower bound"), palette::blue);
  bar_rows::add_patch(legend, plain("to the upper bound"), palette::vermillion);
  legend.add(6.0, plain("baseline"), [](Svg& svg, Point at) {
    svg.line({at.x + 3.0, at.y - 4.5}, {at.x + 3.0, at.y + 4.5}, {palette::ink, 1.0, {}});
  });
  if (noise) bar_rows::add_patch(legend, plain("spread of the baseline in the window"), palette::band);
  return legend;
}

}  // namespace

std::optional<std::string> tornado_figure(const Snapshot& campaign, const results::WindowRow& window,
                                          Place place) {
  const double figure_width = width_of(place.column);
  const std::vector<TornadoBar> bars = tornado_bars(campaign, window.name);
  const results::RealizationRow* baseline = baseline_run(campaign);
  const auto base =
      std::find_if(campaign.window_means.begin(), campaign.window_means.end(), [&](const auto& m) {
        return baseline != nullptr && m.realization == baseline->id && m.window == window.name;
      });
  if (bars.empty() || base == campaign.window_means.end()) return std::nullopt;

  const bool noise = std::isfinite(base->q_c_max_kPa - base->q_c_min_kPa);  // not known of imported averages
  const FlowLegend legend = tornado_legend(noise);
  double label_width = 0.0;
  for (const TornadoBar& bar : bars)
    label_width = std::max(label_width, width(bar.label, bar_rows::label_size));
  const double height = heading_height(campaign, 1, place.ground) + 8.0 +
                        bar_rows::pitch * static_cast<double>(bars.size()) + 50.0 +
                        legend.height(figure_width - 28.0);
  Svg svg(figure_width, height, "tornado", place.ground);
  Rich what = plain(": ") + average_of(window);
  if (const std::string where = place_of(campaign, window); !where.empty())
    what = what + plain(" over " + where);
  if (place.column != Column::single)
    what = what + plain(fmt::format("; baseline {}{}", number(base->q_c_mean_kPa, 4), unit_behind(window)));
  const double top =
      draw_heading(svg, campaign, campaign.campaign.title, {window_line(window, what, figure_width)});
  const double left = 14.0 + label_width + 8.0;
  const Box area{left, top + 4.0, figure_width - 14.0 - left,
                 bar_rows::pitch * static_cast<double>(bars.size()) + 4.0};
  const Axis axis = tornado_axis(bars, base->q_c_mean_kPa, area.x, area.right());

  draw_horizontal(svg, area, axis, Edge::bottom, axis_of(window), place.column == Column::single ? 4 : 6);
  if (noise) {
    const double from = std::max(area.x, axis(base->q_c_min_kPa));
    const double to = std::min(area.right(), axis(base->q_c_max_kPa));
    svg.rectangle({from, area.y, to - from, area.height}, palette::band, 0.8);
  }
  const double x0 = axis(base->q_c_mean_kPa);
  svg.line({x0, area.y}, {x0, area.bottom()}, {palette::ink, 1.0, {}});
  double y = area.y + 2.0 + 0.5 * bar_rows::pitch;
  for (const TornadoBar& bar : bars) {
    svg.begin_part(bar_rows::row(svg, y), input_words(campaign, window, bar.row));
    bar_rows::draw_label(svg, area, y, bar.label);
    draw_swing(svg, axis, bar, y, base->q_c_mean_kPa);
    svg.end_part();
    y += bar_rows::pitch;
  }
  svg.line({area.x, area.bottom()}, {area.right(), area.bottom()}, {palette::ink, 0.6, {}});
  legend.draw(svg, {14.0, area.bottom() + 46.0}, figure_width - 28.0);
  return svg.document(fmt::format("Tornado: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

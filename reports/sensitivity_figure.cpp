#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/axis.hpp"
#include "drawing/bar_rows.hpp"
#include "drawing/flow_legend.hpp"
#include "drawing/palette.hpp"
#include "reports/figures.hpp"
#include "reports/labels.hpp"
#include "reports/notes.hpp"

namespace cpt::reports {
namespace {

using drawing::Axis, drawing::Box, drawing::Column, drawing::decimals, drawing::Edge, drawing::FlowLegend,
    drawing::plain, drawing::Point, drawing::Rich, drawing::Svg, drawing::symbolic;
namespace palette = drawing::palette;
namespace bar_rows = drawing::bar_rows;

using results::SensitivityRow;
using results::Snapshot;

constexpr double index_value_room = 44.0;

std::vector<SensitivityRow> sorted_rows(const Snapshot& campaign, const std::string& window) {
  std::vector<SensitivityRow> rows = sensitivity_in(campaign, window);
  const auto rank = [](const SensitivityRow& row) { return std::isfinite(row.si_abs) ? row.si_abs : -1.0; };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const SensitivityRow& a, const SensitivityRow& b) { return rank(a) > rank(b); });
  return rows;
}

void draw_index(Svg& svg, const Axis& axis, const SensitivityRow& row, double y) {
  if (!std::isfinite(row.si)) return;
  svg.rectangle(
      {axis.from, y - 0.5 * bar_rows::bar_height, axis(row.si_abs) - axis.from, bar_rows::bar_height},
      row.si < 0.0 ? palette::orange : palette::blue, within_noise(row) ? 0.4 : 1.0);
}

/// How far the index goes at either end of its interval [-].
double end_of(const SensitivityRow& row) {
  return row.si_abs + (std::isfinite(row.si_half_width) ? row.si_half_width : 0.0);
}

/// The interval that the repeats give, about the end of the bar.
void draw_interval(Svg& svg, const Axis& axis, const SensitivityRow& row, double y) {
  if (!std::isfinite(row.si) || !std::isfinite(row.si_half_width)) return;
  const double from = axis(std::max(0.0, row.si_abs - row.si_half_width)), to = axis(end_of(row));
  bar_rows::draw_whisker(svg, from, to, y);
}

/// The index behind its bar, or why there is none; kept clear of the noise line.
void draw_value(Svg& svg, const Axis& axis, const SensitivityRow& row, double y, bool waits) {
  const double base = y + 0.36 * bar_rows::value_size;
  if (!std::isfinite(row.si)) {
    const double room = axis.to - axis.from - 8.0;
    const std::string why = waits ? "not run yet" : shortened("× " + row.note, room, bar_rows::value_size);
    svg.text({axis.from + 4.0, base}, plain(why),
             {.size = bar_rows::value_size, .color = waits ? palette::muted : palette::warn, .halo = true});
    return;
  }
  const Rich text = plain(decimals(row.si, 3));
  double x = axis(end_of(row)) + 3.0;
  const double noise = axis(row.si_noise);
  if (noise > x - 2.0 && noise < x + width(text, bar_rows::value_size) + 2.0) x = noise + 3.0;
  svg.text({x, base}, text, {.size = bar_rows::value_size, .halo = true});
}

FlowLegend sensitivity_legend(const SensitivityRow& row) {
  FlowLegend legend;
  bar_rows::add_patch(legend, plain("positive"), palette::blue);
  bar_rows::add_patch(legend, plain("negative"), palette::orange);
  const bool repeated = std::isfinite(row.si_half_width);
  legend.add(18.0, plain(repeated ? "within the repeats' noise" : "within noise"), [](Svg& svg, Point at) {
    svg.rectangle({at.x, at.y - 3.5, 9.0, 7.0}, palette::blue, 0.4);
    svg.rectangle({at.x + 9.0, at.y - 3.5, 9.0, 7.0}, palette::orange, 0.4);
  });
  if (std::isfinite(row.si_noise))
    legend.add(16.0, symbolic("SI_noise") + plain(" = " + decimals(row.si_noise, 4)), [](Svg& svg, Point at) {
      svg.line(at, {at.x + 16.0, at.y}, {palette::ink, 1.0, "4 2.5"});
    });
  if (repeated)
    legend.add(12.0, plain("95 %, repeats"),
               [](Svg& svg, Point at) { bar_rows::draw_whisker(svg, at.x, at.x + 12.0, at.y); });
  return legend;
}

}  // namespace

std::optional<std::string> sensitivity_figure(const Snapshot& campaign, const results::WindowRow& window,
                                              Place place) {
  const double figure_width = width_of(place.column);
  const std::vector<SensitivityRow> rows = sorted_rows(campaign, window.name);
  if (rows.empty() || !std::isfinite(rows.front().si)) return std::nullopt;
  const double noise = rows.front().si_noise;
  const FlowLegend legend = sensitivity_legend(rows.front());

  std::vector<Rich> labels;
  double label_width = 0.0;
  for (const SensitivityRow& row : rows) {
    labels.push_back(symbol_of(campaign, parameter_of(campaign, row.parameter)));
    label_width = std::max(label_width, width(labels.back(), bar_rows::label_size));
  }
  const double plot_height = bar_rows::pitch * static_cast<double>(rows.size()) + 4.0;
  Svg svg(figure_width,
          heading_height(campaign, 1, place.ground) + 4.0 + plot_height + 50.0 +
              legend.height(figure_width - 28.0),
          "sensitivity", place.ground);
  Rich what = plain(": ") + symbolic("SI = (q_upper − q_lower) / q_upper");
  if (const std::string where = place_of(campaign, window); !where.empty())
    what = what + plain(" over " + where);
  const double top =
      draw_heading(svg, campaign, campaign.campaign.title, {window_line(window, what, figure_width)});
  const double left = 14.0 + label_width + 8.0;
  const Box plot{left, top + 4.0, figure_width - 14.0 - left, plot_height};
  // The widest interval need not be that of the largest index.
  double largest = std::isfinite(noise) ? noise : 0.0;
  for (const SensitivityRow& row : rows)
    if (std::isfinite(row.si)) largest = std::max(largest, end_of(row));
  const double high = largest > 0.0 ? largest * plot.width / (plot.width - index_value_room) : 1.0;
  const Axis axis{0.0, high, plot.x, plot.right()};

  draw_horizontal(svg, plot, axis, Edge::bottom, plain("sensitivity index |SI|"),
                  place.column == Column::single ? 4 : 6);
  const auto row_y = [&](std::size_t i) {
    return plot.y + 2.0 + bar_rows::pitch * (static_cast<double>(i) + 0.5);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) draw_index(svg, axis, rows[i], row_y(i));
  if (std::isfinite(noise))
    svg.line({axis(noise), plot.y}, {axis(noise), plot.bottom()}, {palette::ink, 1.0, "4 2.5"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    svg.begin_part(bar_rows::row(svg, row_y(i)), input_words(campaign, window, rows[i]));
    bar_rows::draw_label(svg, plot, row_y(i), labels[i]);
    draw_interval(svg, axis, rows[i], row_y(i));
    draw_value(svg, axis, rows[i], row_y(i), to_come(campaign, rows[i]));
    svg.end_part();
  }
  svg.line({plot.x, plot.y}, {plot.x, plot.bottom()}, {palette::ink, 0.6, {}});
  svg.line({plot.x, plot.bottom()}, {plot.right(), plot.bottom()}, {palette::ink, 0.6, {}});

  legend.draw(svg, {14.0, plot.bottom() + 46.0}, figure_width - 28.0);
  return svg.document(fmt::format("Sensitivity index: {}, {}", campaign.campaign.title, window.name));
}

}  // namespace cpt::reports

#include "reports/diagnosis/sounding_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "drawing/palette.hpp"
#include "reports/diagnosis/errors.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::FlowLegend, drawing::Pen,
    drawing::plain, drawing::Point, drawing::Rich, drawing::Svg;
namespace palette = drawing::palette;

constexpr double panels_top = 82.0, panels_left = 48.0, panels_right = 12.0, gap_across = 40.0,
                 gap_down = 56.0;
constexpr double least_figure_width = 360.0, legend_left = 12.0;
constexpr std::size_t most_across = 4;
constexpr std::string_view above_fill = "#fbe3c0", below_fill = "#d3e9f8";  // light orange and sky

// As the curves of the figure lie, in the mean over the interval.
bool is_below(const DiagnosisInput& input, const diagnosis::Mismatch& m) {
  return departure(input, m).percent < 0.0;
}

}  // namespace

SoundingPanels::SoundingPanels(const DiagnosisInput& input, double panel_width, double panel_height,
                               FlowLegend legend)
    : input_(input), legend_(std::move(legend)), panel_width_(panel_width), panel_height_(panel_height) {
  const std::size_t count = input.soundings.size();
  const auto across = static_cast<double>(std::min(count, most_across));
  const auto down = static_cast<double>((count + most_across - 1) / most_across);
  const double beside = panels_left + (across - 1.0) * gap_across + panels_right;
  width_ = std::max(least_figure_width, beside + across * panel_width);
  panel_width_ = (width_ - beside) / across;
  legend_top_ = panels_top + down * panel_height + (down - 1.0) * gap_down + 16.0;
  height_ = legend_top_ + legend_.height(width_ - 2.0 * legend_left) + 4.0;

  range_ = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto take = [&](double depth) {
    if (!std::isfinite(depth)) return;
    range_ = {std::min(range_.low, depth), std::max(range_.high, depth)};
  };
  for (const diagnosis::Cell& cell : input.diagnosis.compared.cells)
    for (const double side : {-0.5, 0.5}) take(cell.depth + side * cell.height);
  for (const Sounding& sounding : input.soundings)
    for (const double depth : sounding.baseline.depth) take(depth);
  // From the surface, unless all lies far below it.
  if (range_.low > 0.0 && range_.low < 0.3 * range_.high) range_.low = 0.0;
}

Box SoundingPanels::box(std::size_t sounding) const {
  const auto column = static_cast<double>(sounding % most_across);
  const auto row = static_cast<double>(sounding / most_across);
  return {panels_left + column * (panel_width_ + gap_across), panels_top + row * (panel_height_ + gap_down),
          panel_width_, panel_height_};
}

Axis SoundingPanels::depth(std::size_t sounding) const {
  const Box b = box(sounding);
  return {range_.low, range_.high, b.y, b.bottom()};
}

void SoundingPanels::draw_ground(Svg& svg, std::size_t sounding, const Axis& across,
                                 const Rich& title) const {
  const Box b = box(sounding);
  const Axis down = depth(sounding);
  svg.begin_clip(b);
  for (const diagnosis::Mismatch& m : input_.diagnosis.location.mismatches)
    if (m.sounding < 0 || m.sounding == static_cast<int>(sounding))
      svg.rectangle({b.x, down(m.from), b.width, down(m.to) - down(m.from)},
                    is_below(input_, m) ? below_fill : above_fill);
  svg.end_clip();
  draw_horizontal(svg, b, across, Edge::top, title, 4);
  draw_vertical(svg, b, down, sounding % most_across == 0 ? plain("depth (m)") : Rich{}, 8);
  svg.text({b.x + 0.5 * b.width, b.y - 34.0},
           plain(shortened(input_.soundings[sounding].name, b.width, 8.5, true)),
           {.size = 8.5, .anchor = Anchor::middle, .bold = true});
}

void SoundingPanels::draw_legend(Svg& svg) const {
  legend_.draw(svg, {legend_left, legend_top_}, width_ - 2.0 * legend_left);
}

std::vector<Point> cell_line(const DiagnosisInput& input, std::size_t sounding, const VectorXd& values,
                             const Axis& across, const Axis& depth) {
  std::vector<Point> points;
  const diagnosis::Cell* last = nullptr;
  const std::vector<diagnosis::Cell>& cells = input.diagnosis.compared.cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const diagnosis::Cell& cell = cells[i];
    if (cell.sounding != static_cast<int>(sounding)) continue;
    if (last != nullptr && cell.depth - last->depth > 1.5 * cell.height)
      points.push_back({std::nan(""), std::nan("")});
    points.push_back({across(values(static_cast<Index>(i))), depth(cell.depth)});
    last = &cell;
  }
  return points;
}

Pen rival_pen(std::size_t k) {
  constexpr std::array colors = {palette::orange, palette::purple, palette::sky};
  return {colors[k], 0.9, "3 1.5"};
}

void add_rivals(FlowLegend& legend, const DiagnosisInput& input) {
  const std::vector<std::size_t> others = rivals(input);
  for (std::size_t k = 0; k < others.size(); ++k)
    legend.line(plain("or with: " + title_of(input, others[k])), rival_pen(k));
}

void add_intervals(FlowLegend& legend, const DiagnosisInput& input) {
  const auto& mismatches = input.diagnosis.location.mismatches;
  if (std::ranges::any_of(mismatches, [&](const auto& m) { return !is_below(input, m); }))
    legend.patch(plain("mismatch, recording above"), above_fill);
  if (std::ranges::any_of(mismatches, [&](const auto& m) { return is_below(input, m); }))
    legend.patch(plain("mismatch, recording below"), below_fill);
}

std::string best_effect_line(const DiagnosisInput& input) {
  const diagnosis::Diagnosis& d = input.diagnosis;
  if (!d.best) return "no effect was tried";
  return fmt::format("best effect{}: {}",
                     d.with_best().rmse > d.null.recalibrated.rmse ? " (makes the fit worse)" : "",
                     title_of(input, d.best->mechanism));
}

}  // namespace cpt::reports::diagnosed

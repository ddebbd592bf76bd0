#include "reports/depth_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include "drawing/palette.hpp"
#include "reports/notes.hpp"
#include "reports/push_start_mark.hpp"
#include "reports/units.hpp"
#include "results/push/push_start.hpp"

namespace cpt::reports {
namespace {

using drawing::Anchor, drawing::Box, drawing::Edge, drawing::Pen, drawing::plain, drawing::Point,
    drawing::Range, drawing::Rich, drawing::Span, drawing::Svg, drawing::symbolic, drawing::widened;
namespace palette = drawing::palette;

/// Median of a value and up to two neighbours on either side: a spike of one or two bins must not set the
/// scale.
double median_around(const std::vector<double>& values, std::size_t i) {
  std::vector<double> near;
  for (std::size_t k = i < 2 ? 0 : i - 2; k <= i + 2 && k < values.size(); ++k)
    if (std::isfinite(values[k])) near.push_back(values[k]);
  if (near.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(near.begin(), near.end());
  return near[(near.size() - 1) / 2];
}

}  // namespace

std::vector<SoilTint> DepthPlot::tinted(const std::vector<results::LayerRow>& layers) const {
  std::vector<std::string> soils;  // in the order of their first layers, the plain one first
  for (const results::LayerRow& layer : layers)
    if (std::ranges::find(soils, layer.soil) == soils.end())
      soils.insert(layer.soil == "sand" ? soils.begin() : soils.end(), layer.soil);
  std::vector<SoilTint> seen;
  for (std::size_t k = 1; k < soils.size(); ++k)
    if (std::ranges::any_of(layers, [&](const results::LayerRow& layer) {
          return layer.soil == soils[k] && layer.top_m < depth.high && layer.bottom_m > depth.low;
        }))
      seen.push_back({soils[k], palette::tints[(k - 1) % palette::tints.size()]});
  return seen;
}

void DepthPlot::draw_ground(Svg& svg, const std::vector<results::LayerRow>& layers, int ticks_across,
                            int ticks_down) const {
  const std::vector<SoilTint> tints = tinted(layers);
  for (const results::LayerRow& layer : layers) {
    const double top = std::max(layer.top_m, depth.low);
    const double bottom = std::min(layer.bottom_m, depth.high);
    const auto tint = std::ranges::find(tints, layer.soil, &SoilTint::soil);
    if (tint != tints.end() && bottom > top)
      svg.rectangle({box.x, depth(top), box.width, depth(bottom) - depth(top)}, tint->colour);
  }
  draw_horizontal(svg, box, q_c, Edge::top, symbolic("q_c (kPa)"), ticks_across);
  draw_vertical(svg, box, depth, plain("depth (m)"), ticks_down);
}

void DepthPlot::draw_curve(Svg& svg, const solver::DepthProfile& profile, const Pen& pen) const {
  std::vector<Point> points;
  for (std::size_t i = 0; i < profile.depth.size(); ++i)
    points.push_back({q_c(profile.q_c[i] / kPa), depth(profile.depth[i])});
  const std::size_t start = results::bins_of_start(profile);
  const std::span<const Point> all(points);
  if (start > 0) svg.polyline(all.first(start + 1), {palette::faint, 0.6 * pen.width, "1.5 1.5"});
  svg.polyline(all.subspan(start), pen);
}

void mark_start(Svg& svg, const DepthPlot& plot, const solver::DepthProfile& profile) {
  const std::size_t start = results::bins_of_start(profile);
  if (start == 0 || profile.depth[start] > plot.depth.high || profile.depth[0] < plot.depth.low) return;
  svg.text({plot.box.right() - 4.0, plot.depth(profile.depth[0]) - 2.5}, plain("start of the push"),
           {.size = 6.5, .anchor = Anchor::end, .color = palette::muted, .halo = true});
}

void DepthPlot::draw_frame(Svg& svg) const { svg.frame(box, {palette::ink, 0.6, {}}); }

void DepthPlot::draw_window_mark(Svg& svg, const results::WindowRow& window) const {
  if (!window.problem.empty()) return;
  const double top = depth(std::clamp(window.from_m, depth.low, depth.high));
  const double bottom = depth(std::clamp(window.to_m, depth.low, depth.high));
  const double x = box.right();
  svg.rectangle({x + 1.5, top, 3.0, std::max(bottom - top, 1.2)}, palette::ink);
}

DepthPlot whole_profile(const results::Snapshot& campaign, const std::vector<results::CurveRow>& curves,
                        const Box& box) {
  double deepest = 0.0;
  double least = 0.0;
  double largest = 0.0;
  for (const results::CurveRow& curve : curves) {
    for (const double z : curve.profile.depth) deepest = std::max(deepest, z);
    const bool whole =
        std::any_of(campaign.realizations.begin(), campaign.realizations.end(),
                    [&](const auto& run) { return run.id == curve.realization && run.completed(); });
    if (!whole && curves.size() > 1) continue;  // a run that blew up must not set the scale
    for (std::size_t i = results::bins_of_start(curve.profile); i < curve.profile.q_c.size(); ++i) {
      const double q = median_around(curve.profile.q_c, i) / kPa;
      if (!std::isfinite(q)) continue;
      least = std::min(least, q);
      largest = std::max(largest, q);
    }
  }
  const Range q = widened(least, largest, 0.04);
  return {box,
          {least < 0.0 ? q.low : 0.0, q.high, box.x, box.right()},
          {0.0, deepest > 0.0 ? deepest : 1.0, box.y, box.bottom()}};
}

void Legend::entry(const Rich& text) {
  const double room = width_ - glyph_width - 5.0;
  const double x = x_ + glyph_width + 5.0, base = y_ + 0.36 * text_size;
  y_ += pitch;
  if (width(text, text_size) <= room) return svg_.text({x, base}, text, {.size = text_size});
  std::string whole;
  for (const Span& span : text) whole += span.text;
  const std::vector<std::string> lines = wrapped(whole, text_size, room);
  for (std::size_t i = 0; i < lines.size(); ++i)
    svg_.text({x, base + line_pitch * static_cast<double>(i)}, plain(lines[i]), {.size = text_size});
  y_ += line_pitch * static_cast<double>(lines.size() - 1);
}

void Legend::line(const Rich& text, const Pen& pen) {
  svg_.line({x_, y_}, {x_ + glyph_width, y_}, pen);
  entry(text);
}

void Legend::patch(const Rich& text, std::string_view fill) {
  svg_.rectangle({x_, y_ - 4.0, glyph_width, 8.0}, fill);
  entry(text);
}

void Legend::dot(const Rich& text, std::string_view fill) {
  svg_.circle({x_ + 0.5 * glyph_width, y_}, 2.6, fill, {palette::ink, 0.4, {}});
  entry(text);
}

void Legend::mark(const Rich& text) {
  svg_.rectangle({x_ + 0.5 * glyph_width - 1.5, y_ - 4.0, 3.0, 8.0}, palette::ink);
  entry(text);
}

}  // namespace cpt::reports

#include "reports/view/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/palette.hpp"
#include "reports/depth_plot.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::view {
namespace {

using drawing::Anchor, drawing::Axis, drawing::Box, drawing::Edge, drawing::number, drawing::Pen,
    drawing::Picture, drawing::plain, drawing::Point, drawing::Rich, drawing::Svg, drawing::symbolic,
    drawing::Tick;
namespace palette = drawing::palette;

// Lengths in points.
constexpr double bar_height = 7.0, bar_above = 26.0;  // the colour bar's upper edge over the panel's
constexpr double text_size = 8.5, tick_size = 7.5;

constexpr Pen edge{palette::ink, 0.6, {}};

void draw_colour_bar(Svg& svg, const Box& panel, const Panel& shown) {
  const ViewQuantity& quantity = *shown.quantity;
  const ColourScale& scale = shown.scale;
  const Rich unit = quantity.unit.empty() ? Rich{} : plain(fmt::format(" ({})", quantity.unit));
  const Rich symbol = symbolic(quantity.symbol) + unit;
  Rich title = plain(fmt::format("{} ", quantity.meaning)) + symbol;
  if (width(title, text_size) > panel.width) title = symbol;
  const Box bar{panel.x + 6.0, panel.y - bar_above, panel.width - 12.0, bar_height};
  svg.text({panel.x + 0.5 * panel.width, bar.y - 6.0}, title, {.size = text_size, .anchor = Anchor::middle});

  Picture bar_shades{shades, 1, {}};
  for (int i = 0; i < shades; ++i)
    bar_shades.pixels.push_back(shade_at(scale.map, (i + 0.5) / shades).value());
  svg.image(bar, png_uri(bar_shades));
  // Pointed where values may lie beyond the end.
  const double middle = bar.y + 0.5 * bar.height;
  if (scale.kind != ScaleKind::from_zero || scale.low > 0.0)
    svg.polygon(std::array{Point{bar.x, bar.y}, Point{bar.x - 5.0, middle}, Point{bar.x, bar.bottom()}},
                hex(shade_at(scale.map, 0.0)));
  svg.polygon(std::array{Point{bar.right(), bar.y}, Point{bar.right() + 5.0, middle},
                         Point{bar.right(), bar.bottom()}},
              hex(shade_at(scale.map, 1.0)));
  const auto at = [&](const Tick& tick) { return bar.x + scale.place(tick.value) * bar.width; };
  const auto touching = [&](const Tick& a, const Tick& b) {
    return at(b) - at(a) < 0.5 * (width(plain(a.label), tick_size) + width(plain(b.label), tick_size)) + 4.0;
  };
  std::vector<Tick> ticks = scale.ticks(5);
  for (int count = 4; count >= 2 && std::ranges::adjacent_find(ticks, touching) != ticks.end(); --count)
    ticks = scale.ticks(count);
  for (const Tick& tick : ticks) {
    const double x = at(tick);
    svg.line({x, bar.bottom()}, {x, bar.bottom() + 2.5}, edge);
    svg.text({x, bar.bottom() + 10.0}, plain(tick.label), {.size = tick_size, .anchor = Anchor::middle});
  }
}

// Steel: strips that are lightest a third of the way to the edge, as a round bar is.
void draw_penetrometer(Svg& svg, const Geometry& g, double tip_depth, const Axis& r, const Axis& depth,
                       double upper_edge) {
  constexpr int strips = 12;
  const double shoulder = tip_depth - g.cone_height;
  const double above = std::min(upper_edge, shoulder);
  for (int i = 0; i < strips; ++i) {
    const double from = g.cone_radius * i / strips, to = g.cone_radius * (i + 1) / strips;
    const auto face = [&](double at) { return tip_depth - g.cone_height * at / g.cone_radius; };
    const double shine = std::exp(-8.0 * std::pow((i + 0.5) / strips - 0.33, 2));
    const Colour steel = mixed(Colour::of(0x6f7880), Colour::of(0xe4e8eb), shine);
    const double right = std::min(r(to) + 0.2, r(g.cone_radius));
    svg.polygon(std::array{Point{r(from), depth(above)}, Point{right, depth(above)},
                           Point{right, depth(face(to))}, Point{r(from), depth(face(from))}},
                hex(steel));
  }
  const double sleeve = shoulder - g.sleeve_length;
  for (const double joint : {shoulder, sleeve})
    svg.line({r(0.0), depth(joint)}, {r(g.cone_radius), depth(joint)}, {palette::muted, 0.5, {}});
  svg.polyline(std::array{Point{r(g.cone_radius), depth(above)}, Point{r(g.cone_radius), depth(shoulder)},
                          Point{r(0.0), depth(tip_depth)}},
               {palette::ink, 0.8, {}});
}

void draw_chamber(Svg& svg, const Geometry& g, const Box& box, const Axis& r, const Axis& depth) {
  constexpr std::string_view steel = "#4a4a4a";
  if (depth.high > g.soil_height)
    svg.rectangle({box.x, depth(g.soil_height), box.width, box.bottom() - depth(g.soil_height)}, steel);
  if (r.high <= g.chamber_radius) return;
  const double wall = r(g.chamber_radius);
  svg.rectangle({wall, box.y, box.right() - wall, box.height}, g.flexible_wall ? palette::sky : steel);
  svg.line({wall, box.y}, {wall, box.bottom()}, {palette::ink, 0.8, {}});
}

// Where they were before the push, at the right edge; nothing where the soil is all one.
void draw_layer_names(Svg& svg, const std::vector<results::LayerRow>& layers, const Box& box,
                      const Axis& depth) {
  if (std::ranges::all_of(layers, [&](const auto& layer) { return layer.soil == layers.front().soil; }))
    return;
  for (const results::LayerRow& layer : layers) {
    const double from = depth(std::max(layer.top_m, depth.low));
    const double to = depth(std::min(layer.bottom_m, depth.high));
    if (to - from > 10.0)
      svg.text({box.right() - 3.0, 0.5 * (from + to) + 2.5}, plain(layer.soil),
               {.size = 7.0, .anchor = Anchor::end, .color = palette::muted, .halo = true});
  }
}

void draw_panel(Svg& svg, const View& view, const Box& box, const Window& window, double tip_depth,
                const Panel& panel, const Picture& picture, bool first) {
  const Axis r{0.0, window.radius, box.x, box.right()};
  const Axis depth{window.top, window.bottom, box.y, box.bottom()};
  draw_colour_bar(svg, box, panel);
  draw_horizontal(svg, box, r, Edge::bottom, plain("distance from the axis (m)"), 4);
  if (first) draw_vertical(svg, box, depth, plain("depth (m)"), 8);
  svg.image(box, png_uri(picture));
  svg.begin_clip(box);
  draw_chamber(svg, view.geometry, box, r, depth);
  draw_penetrometer(svg, view.geometry, tip_depth, r, depth, window.top);
  // The surcharge, where there is room for its name.
  const double room = depth(std::min(0.0, window.bottom)) - box.y;
  if (room > 14.0)
    svg.text({0.5 * (r(view.geometry.cone_radius) + box.right()), box.y + std::min(0.5 * room, 20.0) + 3.0},
             plain("surcharge"), {.size = tick_size, .anchor = Anchor::middle, .color = palette::muted});
  if (first) draw_layer_names(svg, view.geometry.layers, box, depth);
  svg.end_clip();
  svg.frame(box, edge);
}

// q_c of the bin nearest to a depth; NaN without a profile.
double q_c_at(const solver::DepthProfile& profile, double depth) {
  if (profile.depth.empty()) return std::nan("");
  const auto after = std::ranges::lower_bound(profile.depth, depth);
  auto i = static_cast<std::size_t>(after - profile.depth.begin());
  if (i == profile.depth.size() || (i > 0 && depth - profile.depth[i - 1] < profile.depth[i] - depth)) --i;
  return profile.q_c[i];
}

void draw_strip(Svg& svg, const View& view, const Box& box, const Window& window, double tip_depth) {
  const results::CurveRow curve{1, view.profile};
  DepthPlot plot = whole_profile({}, {curve}, box);
  // Beside the whole chamber the marker is level with the tip; else there is room for it at the end.
  plot.depth.high *= 1.03;
  if (!view.radius) plot.depth = {window.top, window.bottom, box.y, box.bottom()};
  plot.draw_ground(svg, view.geometry.layers, 3, 8);
  solver::DepthProfile so_far;
  for (std::size_t i = 0; i < view.profile.depth.size() && view.profile.depth[i] <= tip_depth; ++i) {
    so_far.depth.push_back(view.profile.depth[i]);
    so_far.q_c.push_back(view.profile.q_c[i]);
  }
  svg.begin_clip(box);
  plot.draw_curve(svg, view.profile, {palette::faint, 0.8, {}});
  plot.draw_curve(svg, so_far, {palette::blue, 1.1, {}});
  const double y = plot.depth(tip_depth);
  svg.line({box.x, y}, {box.right(), y}, {palette::vermillion, 0.7, "3 2"});
  const double q_c = q_c_at(view.profile, tip_depth);
  if (std::isfinite(q_c)) svg.circle({plot.q_c(q_c * 1e-3), y}, 3.0, palette::vermillion, edge);
  draw_layer_names(svg, view.geometry.layers, box, plot.depth);
  svg.end_clip();
  plot.draw_frame(svg);
}

void draw_words(Svg& svg, const View& view, const Layout& layout, double tip_depth) {
  const double right = layout.width - Layout::margin;
  const double q_c = q_c_at(view.profile, tip_depth);
  const Rich state = plain(fmt::format("tip {:.3f} m deep", tip_depth)) +
                     (std::isfinite(q_c) ? plain(",  ") + symbolic("q_c") +
                                               plain(fmt::format(" = {} kPa", number(q_c * 1e-3, 3)))
                                         : Rich{});
  const double room = right - Layout::margin - width(state, 11.0, true) - 16.0;
  svg.text({Layout::margin, 20.0}, plain(shortened(view.title, room, 11.0, true)),
           {.size = 11.0, .bold = true});
  svg.text({right, 20.0}, state, {.size = 11.0, .anchor = Anchor::end, .bold = true});
  svg.text({Layout::margin, 33.0}, plain(shortened(view.subtitle, right - Layout::margin, text_size)),
           {.size = text_size, .color = palette::muted});
  const bool gridded = view.grid > 0.0 && std::ranges::any_of(view.panels, [](const Panel& panel) {
                         return panel.quantity->name == "displacement";
                       });
  const std::string note =
      fmt::format("Colours are the same at all depths; pointed ends: values beyond.{}",
                  gridded ? fmt::format(" The grid was squares of {:.3g} mm.", view.grid * 1e3) : "");
  svg.text({right, layout.height - 8.0}, plain(note),
           {.size = 7.0, .anchor = Anchor::end, .color = palette::muted});
}

}  // namespace

std::string frame(const View& view, const Layout& layout, double tip_depth, const DrawnPoints& points) {
  const Window window = window_at(view.geometry, view.radius, tip_depth);
  const Raster raster(points, window, layout.columns, layout.rows);
  Svg svg(layout.width, layout.height, "view");
  draw_words(svg, view, layout, tip_depth);
  draw_strip(svg, view, layout.strip, window, tip_depth);
  for (std::size_t i = 0; i < view.panels.size(); ++i)
    draw_panel(svg, view, layout.panels[i], window, tip_depth, view.panels[i],
               panel_picture(view, i, raster, window), i == 0);
  return svg.document(view.title);
}

}  // namespace cpt::reports::view

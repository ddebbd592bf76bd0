// Where things are: in the chamber, and on the frame.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "reports/view/frame.hpp"

namespace cpt::reports::view {
namespace {

// Lengths in points.
constexpr double strip_left = 50.0, strip_width = 104.0;
constexpr double before_panels = 50.0, between_panels = 16.0, panels_room = 480.0, widest = 200.0;
constexpr double tallest = 380.0, top = 84.0, below_panels = 54.0;

// Settings do not name the soils where these are the two that every setup has.
std::size_t soil_count(const results::StoredPush& push) {
  if (!push.has_setting("soils")) return solver::Setup{}.soils.size();
  const std::string soils = push.setting("soils");  // "dense norsand; clay tresca"
  return static_cast<std::size_t>(std::ranges::count(soils, ';')) + 1;
}

}  // namespace

Geometry geometry_of(const results::StoredPush& push) {
  const double radius = 0.5 * push.number("penetrometer.diameter_m");
  const double half_apex = 0.5 * push.number("penetrometer.apex_deg") / 180.0 * std::numbers::pi;
  Geometry geometry{radius,
                    radius / std::tan(half_apex),
                    push.number("penetrometer.sleeve_length_m"),
                    push.number("chamber.radius_m"),
                    push.number("chamber.soil_height_m"),
                    push.setting("chamber.wall") == "flexible",
                    {},
                    soil_count(push)};
  std::istringstream layers(push.setting("layers"));  // "0 to 0.23 sand; 0.23 to 1 clay"
  std::string to;
  for (results::LayerRow layer{}; layers >> layer.top_m >> to >> layer.bottom_m >> layer.soil;) {
    if (layer.soil.ends_with(';')) layer.soil.pop_back();
    geometry.layers.push_back(layer);
  }
  return geometry;
}

Window window_at(const Geometry& geometry, std::optional<double> radius, double tip_depth) {
  if (radius) return {*radius, tip_depth - 0.8 * *radius, tip_depth + 1.2 * *radius};
  return {1.04 * geometry.chamber_radius, -0.06 * geometry.soil_height, 1.02 * geometry.soil_height};
}

Layout layout_of(const View& view) {
  const Window window = window_at(view.geometry, view.radius, 0.0);
  const double shape = (window.bottom - window.top) / window.radius;
  const auto count = static_cast<double>(view.panels.size());
  double width = std::min(widest, (panels_room - (count - 1.0) * between_panels) / count);
  const double height = std::min(tallest, width * shape);
  width = height / shape;
  const double first = strip_left + strip_width + before_panels;
  Layout layout{};
  layout.width = first + count * width + (count - 1.0) * between_panels + Layout::margin;
  layout.pixels_per_point = view.width / layout.width;
  const auto pixels = [&](double length) { return std::round(length * layout.pixels_per_point); };
  const auto snapped = [&](double length) { return pixels(length) / layout.pixels_per_point; };
  layout.columns = static_cast<int>(pixels(width));
  layout.rows = static_cast<int>(pixels(height));
  layout.height = snapped(top + height + below_panels);
  layout.strip = {strip_left, snapped(top), strip_width, snapped(height)};
  for (std::size_t i = 0; i < view.panels.size(); ++i)
    layout.panels.push_back({snapped(first + static_cast<double>(i) * (width + between_panels)), snapped(top),
                             layout.columns / layout.pixels_per_point,
                             layout.rows / layout.pixels_per_point});
  return layout;
}

}  // namespace cpt::reports::view

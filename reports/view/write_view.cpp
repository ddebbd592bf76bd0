#include "reports/view/write_view.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/gif.hpp"
#include "drawing/palette.hpp"
#include "reports/figure_files.hpp"
#include "reports/picture_files.hpp"

namespace cpt::reports::view {
namespace {

using drawing::GifAnimation, drawing::Range;
namespace palette = drawing::palette;

constexpr double last_frame_seconds = 2.0;

// Depths above the start of the push were all stored at the start: one of them will do.
std::vector<results::StoredField> chosen(const std::vector<results::StoredField>& stored, int at_most) {
  std::vector<results::StoredField> all;
  for (const results::StoredField& field : stored)
    if (all.empty() || field.depth != all.back().depth) all.push_back(field);
  const auto count = static_cast<std::size_t>(at_most);
  if (at_most <= 0 || all.size() <= count) return all;
  std::vector<results::StoredField> some;
  for (std::size_t i = 0; i < count; ++i)
    some.push_back(all[count == 1 ? all.size() - 1 : i * (all.size() - 1) / (count - 1)]);
  return some;
}

std::string subtitle_of(const results::StoredPush& push) {
  const auto& origin = push.histories.origin;
  std::string text = fmt::format("{}, realization {}", origin.at("study"), origin.at("realization"));
  if (origin.at("side") == "baseline") text += ", the baseline";
  if (!origin.at("parameter").empty())
    text += fmt::format(", {} = {}", origin.at("parameter"), origin.at("value_text"));
  if (origin.at("status") != "completed")
    text += fmt::format(", the push ended early: {}", origin.at("status"));
  return text;
}

View view_of(const results::StoredPush& push, const ViewRequest& request) {
  const std::string& title = push.histories.origin.at("title");
  View view{title.empty() ? push.name : title,
            subtitle_of(push),
            geometry_of(push),
            push.histories.profile,
            request.radius,
            {},
            request.grid,
            request.width};
  for (const std::string& name : request.show) {
    const ViewQuantity* const quantity = find_view_quantity(name);
    if (quantity == nullptr) throw results::Error(fmt::format("{}: there is no such quantity", name));
    view.panels.push_back({quantity, {quantity->map, quantity->kind}});
  }
  return view;
}

// Scales for all frames, from the soil that they show.
void fit_scales(View& view, const results::StoredPush& push, const std::vector<results::StoredField>& fields,
                const std::map<std::string, Range>& ranges) {
  std::vector<std::vector<Weighted>> values(view.panels.size());
  for (const results::StoredField& field : fields) {
    const DrawnPoints points = drawn_points(view, results::read_field(push, field));
    const Window window = window_at(view.geometry, view.radius, field.depth);
    for (std::size_t k = 0; k < points.r.size(); ++k) {
      if (points.material[k] == view.geometry.soils || points.r[k] > window.radius ||
          points.depth[k] < window.top || points.depth[k] > window.bottom)
        continue;
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i].push_back({points.fields[i][k], points.size[k] * points.size[k]});
    }
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    Panel& panel = view.panels[i];
    panel.scale = fitted(panel.quantity->map, panel.quantity->kind, std::move(values[i]));
    if (const auto range = ranges.find(std::string(panel.quantity->name)); range != ranges.end()) {
      panel.scale.low = range->second.low;
      panel.scale.high = range->second.high;
    }
  }
}

// The colours of an animation: the shades of its maps, then greys and the few colours of lines and marks with
// their way to white, for the edges of letters.
std::vector<std::uint32_t> animation_colours(const View& view) {
  std::vector<std::uint32_t> colours;
  const auto add = [&](Colour colour) {
    if (colours.size() < 255 && std::ranges::find(colours, colour.value()) == colours.end())
      colours.push_back(colour.value());
  };
  for (const Panel& panel : view.panels)
    for (int i = 0; i < shades; ++i) add(shade_at(panel.scale.map, (i + 0.5) / shades));
  add(no_value);
  const Colour white = Colour::of(0xffffff);
  for (const std::string_view line : {palette::vermillion, palette::blue, palette::clay, palette::sky})
    for (const double paler : {0.0, 0.33, 0.66}) add(mixed(colour_of(line), white, paler));
  constexpr int greys = 48;
  for (int i = 0; i <= greys; ++i) add(mixed(Colour::of(0), white, static_cast<double>(i) / greys));
  return colours;
}

}  // namespace

WrittenView write_view(const results::StoredPush& push, const ViewRequest& request,
                       const std::filesystem::path& folder,
                       const std::function<void(std::size_t, std::size_t)>& drawn) {
  const std::vector<results::StoredField> fields = chosen(push.fields, request.frames);
  View view = view_of(push, request);
  fit_scales(view, push, fields, request.ranges);
  const Layout layout = layout_of(view);
  make_directory(folder);

  WrittenView written{{}, {}, view.panels};
  std::optional<GifAnimation> animation;
  for (const results::StoredField& field : fields) {
    const auto file = folder / field.file.filename().replace_extension(".png");
    const DrawnPoints points = drawn_points(view, results::read_field(push, field));
    const drawing::Picture picture = drawn_for(file, [&] {
      return drawing::render(frame(view, layout, field.depth, points), 72.0 * layout.pixels_per_point);
    });
    write_png(picture, file);
    written.frames.push_back(file);
    if (fields.size() > 1) {
      if (!animation) {
        written.animation = folder / (push.name + "-view.gif");
        drawn_for(written.animation,
                  [&] { animation.emplace(picture.width, picture.height, animation_colours(view)); });
      }
      const bool last = written.frames.size() == fields.size();
      drawn_for(written.animation, [&] {
        animation->add(picture, last ? std::max(last_frame_seconds, request.seconds_per_frame)
                                     : request.seconds_per_frame);
      });
    }
    drawn(written.frames.size(), fields.size());
  }
  if (animation)
    write_text(written.animation, drawn_for(written.animation, [&] { return animation->close(); }));
  return written;
}

}  // namespace cpt::reports::view

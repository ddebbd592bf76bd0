#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/palette.hpp"
#include "drawing/svg.hpp"
#include "reports/diagnosis/figures.hpp"
#include "reports/labels.hpp"

namespace cpt::reports::diagnosed {
namespace {

using drawing::Anchor, drawing::Box, drawing::decimals, drawing::number, drawing::plain, drawing::Point,
    drawing::Svg, drawing::TextStyle;
namespace palette = drawing::palette;

constexpr double cell_side = 26.0, label_room = 248.0, matrix_top = 76.0, label_size = 8.0, right = 14.0;
constexpr double full_colour = 10.0;  // [standard deviations] at and above which the colour is deepest

// Orange below the threshold, blue above it, the deeper the further; made light enough for dark figures.
std::string fill_of(double distance, double threshold) {
  const auto mix = [](int from, int to, double share) {
    return static_cast<int>(std::lround(from + share * (to - from)));
  };
  if (distance < threshold) {
    const double share = threshold > 0.0 ? 1.0 - distance / threshold : 0.0;
    return fmt::format("#{:02x}{:02x}{:02x}", mix(253, 230, share), mix(238, 159, share),
                       mix(210, 40, share));
  }
  const double share = std::clamp((distance - threshold) / (full_colour - threshold), 0.0, 1.0);
  return fmt::format("#{:02x}{:02x}{:02x}", mix(240, 100, share), mix(247, 175, share), mix(252, 225, share));
}

std::string printed(double distance) { return decimals(distance, distance < 9.95 ? 1 : 0); }

// Colours from 0 to the deepest with the threshold marked.
void draw_scale(Svg& svg, double x, double y, double threshold) {
  constexpr double scale_width = 160.0, steps = 40.0;
  for (double k = 0.0; k < steps; ++k)
    svg.rectangle({x + k * scale_width / steps, y, scale_width / steps + 0.2, 8.0},
                  fill_of((k + 0.5) / steps * full_colour, threshold));
  const auto at = [&](double value) { return x + value / full_colour * scale_width; };
  svg.frame({x, y, scale_width, 8.0}, {palette::ink, 0.5, {}});
  svg.line({at(threshold), y - 3.0}, {at(threshold), y + 11.0}, {palette::ink, 1.3, {}});
  const TextStyle style{.size = 7.0, .anchor = Anchor::middle};
  svg.text({x, y + 19.0}, plain("0"), style);
  svg.text({at(threshold), y + 19.0}, plain(number(threshold, 2)), style);
  svg.text({at(full_colour), y + 19.0}, plain(fmt::format("≥ {}", number(full_colour, 2))), style);
  svg.text({at(full_colour) + 14.0, y + 7.0},
           plain("standard deviations; framed, below the mark: cannot be told apart"), {.size = 7.0});
}

}  // namespace

std::optional<std::string> isolability_figure(const DiagnosisInput& input) {
  const std::size_t count = input.mechanisms.size();
  if (count == 0) return std::nullopt;
  const diagnosis::Isolability& isolability = input.diagnosis.isolability;
  const double threshold = input.options.indistinguishable;
  const std::vector<std::size_t> order = input.diagnosis.verdict.mechanisms_by_probability();
  const double side = static_cast<double>(count) * cell_side;
  const double width = std::max(500.0, label_room + side + cell_side + 10.0 + right);
  Svg svg(width, matrix_top + side + 44.0, "isolability");
  const auto heading = [&](double x, const std::string& text) {
    svg.text({x + 0.5 * cell_side, matrix_top - 6.0}, plain(text),
             {.size = label_size, .anchor = Anchor::middle});
  };
  // The null's column stands a little apart.
  const double null_x = label_room + side + 10.0;
  for (std::size_t j = 0; j < count; ++j)
    heading(label_room + static_cast<double>(j) * cell_side, fmt::format("{}", j + 1));
  heading(null_x, "none");
  for (std::size_t i = 0; i < count; ++i) {
    const double y = matrix_top + static_cast<double>(i) * cell_side;
    svg.text({label_room - 6.0, y + 0.5 * cell_side + 0.36 * label_size},
             plain(shortened(title_of(input, order[i]), label_room - 34.0, label_size) +
                   fmt::format("  {}", i + 1)),
             {.size = label_size, .anchor = Anchor::end});
    for (std::size_t j = 0; j <= count; ++j) {
      const double x = j == count ? null_x : label_room + static_cast<double>(j) * cell_side;
      const Box box{x, y, cell_side, cell_side};
      const TextStyle style{.size = 7.5, .anchor = Anchor::middle};
      const Point middle{x + 0.5 * cell_side, y + 0.5 * cell_side + 2.7};
      if (i == j) {
        svg.rectangle(box, palette::grid);
        svg.text(middle, plain("–"), style);
        continue;
      }
      const auto row = static_cast<Index>(order[i]);
      const double distance =
          j == count ? isolability.strength(row) : isolability.between(row, static_cast<Index>(order[j]));
      svg.rectangle(box, std::isfinite(distance) ? fill_of(distance, threshold) : "#ffffff");
      svg.text(middle, plain(printed(distance)), style);
      if (distance < threshold)
        svg.frame({x + 1.0, y + 1.0, cell_side - 2.0, cell_side - 2.0}, {palette::ink, 1.1, {}});
    }
  }
  svg.frame({label_room, matrix_top, side, side}, {palette::ink, 0.6, {}});
  svg.frame({null_x, matrix_top, cell_side, side}, {palette::ink, 0.6, {}});
  svg.text({label_room - 6.0, matrix_top - 6.0}, plain("if this is true ..."),
           {.size = 7.5, .anchor = Anchor::end, .color = palette::muted});
  svg.text({label_room, matrix_top - 19.0}, plain("... how far off is the best imitation by effect"),
           {.size = 7.5, .color = palette::muted});
  draw_heading(svg, "What this recording can tell apart",
               plain("distance D between two effects, the study's parameters free to help"));
  draw_scale(svg, 16.0, matrix_top + side + 14.0, threshold);
  return svg.document("Isolability of " + input.title);
}

}  // namespace cpt::reports::diagnosed

// What the figures with one bar a row share. Lengths in points.
#pragma once

#include <string_view>

#include "drawing/flow_legend.hpp"
#include "drawing/svg.hpp"

namespace cpt::drawing::bar_rows {

inline constexpr double pitch = 15.5;
inline constexpr double bar_height = 9.5;
inline constexpr double value_size = 7.0, label_size = 8.5;  ///< of the texts at a bar and left of the plot

/// The row whose middle lies at `y`, as wide as the figure.
[[nodiscard]] Box row(const Svg& svg, double y);
/// Left of the plot, for the row whose middle lies at `y`.
void draw_label(Svg& svg, const Box& plot, double y, const Rich& label);
/// An interval with a short stroke at either end.
void draw_whisker(Svg& svg, double from, double to, double y);
/// An entry with a patch of a colour.
void add_patch(FlowLegend& legend, const Rich& text, std::string_view fill);

}  // namespace cpt::drawing::bar_rows

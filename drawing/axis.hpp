// Linear axes: round tick values and their labels.
#pragma once

#include <string>
#include <vector>

#include "drawing/svg.hpp"

namespace cpt::drawing {

/// Maps data to paper, linearly; `from` may lie to the right of or below `to`.
struct Axis {
  double low, high;  ///< data
  double from, to;   ///< paper, of low and high
  [[nodiscard]] double operator()(double value) const {
    return from + (value - low) / (high - low) * (to - from);
  }
};

struct Tick {
  double value;
  std::string label;
};

/// Multiples of 1, 2 or 5 times a power of ten inside [low, high], about `count` of them, with as many
/// decimals as their step needs. Wants low < high; none where a double cannot tell them apart.
[[nodiscard]] std::vector<Tick> ticks(double low, double high, int count);

/// Widens [low, high] by a fraction on both sides; a range without width becomes one around its value.
struct Range {
  double low, high;
};
[[nodiscard]] Range widened(double low, double high, double fraction);

/// Grid lines, tick labels and title of a horizontal axis along the top or bottom of a plot; fewer ticks than
/// `count` where their labels would touch.
enum class Edge { top, bottom };
void draw_horizontal(Svg& svg, const Box& plot, const Axis& axis, Edge edge, const Rich& title, int count);
/// The same for a vertical axis along the left.
void draw_vertical(Svg& svg, const Box& plot, const Axis& axis, const Rich& title, int count);

}  // namespace cpt::drawing

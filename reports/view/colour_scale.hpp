// From a value to a colour: the scale beside a field.
#pragma once

#include <vector>

#include "drawing/axis.hpp"
#include "reports/view/colour_map.hpp"

namespace cpt::reports::view {

enum class ScaleKind {
  linear,
  from_zero,  ///< linear, beginning at zero
  log,        ///< logarithmic; what is zero or less has the lowest colour
  diverging,  ///< linear, as far below zero as above it
};

struct ColourScale {
  ColourMap map = ColourMap::viridis;
  ScaleKind kind = ScaleKind::linear;
  double low = 0.0, high = 1.0;

  /// Where a value lies on the scale, from 0 to 1; beyond its ends the end. NaN for NaN.
  [[nodiscard]] double place(double value) const;
  /// The shade of a value; `no_value` for NaN.
  [[nodiscard]] Colour operator()(double value) const;
  /// Round values with their labels: multiples of a step, or 1, 2, 5 times powers of ten.
  [[nodiscard]] std::vector<drawing::Tick> ticks(int count) const;
};

/// Where there is material, but not of the kind that has this quantity.
inline constexpr Colour no_value = Colour::of(0xe3e3e3);

/// A value and how much of the picture it covers.
struct Weighted {
  double value, weight;
};

/// A scale for these values. Its ends are the value that 1 % of the weight lies below and the one that 0.5 %
/// lies above (on a logarithmic scale 0.1 %, as the largest stresses are confined to the tip), moved outward
/// to round numbers: a few odd points must not decide the colours of all. Values that are not finite, and on
/// a logarithmic scale those that are not positive, do not count. Without values the ends are 0 and 1 (1 and
/// 10 on a logarithmic scale).
[[nodiscard]] ColourScale fitted(ColourMap map, ScaleKind kind, std::vector<Weighted> values);

}  // namespace cpt::reports::view

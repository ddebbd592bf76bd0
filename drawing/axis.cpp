#include "drawing/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/palette.hpp"

namespace cpt::drawing {
namespace {

constexpr double tick_label_size = 7.5;
constexpr double axis_title_size = 8.5;
constexpr double label_gap = 4.0;
constexpr double tick_length = 3.0;
const Pen grid_pen{palette::grid, 0.4, {}};
const Pen tick_pen{palette::ink, 0.6, {}};

}  // namespace

std::vector<Tick> ticks(double low, double high, int count) {
  const double raw = (high - low) / std::max(1, count);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double ratio = raw / power;
  const double step = power * (ratio < 1.5 ? 1.0 : ratio < 3.5 ? 2.0 : ratio < 7.5 ? 5.0 : 10.0);
  // Below a double's normal numbers, or finer than the digits of its ends, an axis has no ticks.
  if (!(step >= std::numeric_limits<double>::min()) ||
      !(std::max(std::abs(low), std::abs(high)) < 1e15 * step))
    return {};
  const int places = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> out;
  const double slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; ++k)
    out.push_back({k * step, decimals(k * step, places)});
  return out;
}

Range widened(double low, double high, double fraction) {
  double margin = fraction * (high - low);
  if (!(margin > 0.0)) margin = std::max(0.05 * std::abs(low), 1.0e-6);
  return {low - margin, high + margin};
}

namespace {

/// About `count` ticks, fewer where their labels would touch.
std::vector<Tick> ticks_that_fit(const Axis& axis, int count) {
  constexpr double room = 5.0;  // between labels [pt]
  for (; count > 2; --count) {
    std::vector<Tick> all = ticks(axis.low, axis.high, count);
    bool fit = true;
    for (std::size_t i = 1; i < all.size(); ++i)
      fit = fit && std::abs(axis(all[i].value) - axis(all[i - 1].value)) >
                       0.5 * (width(plain(all[i].label), tick_label_size) +
                              width(plain(all[i - 1].label), tick_label_size)) +
                           room;
    if (fit) return all;
  }
  return ticks(axis.low, axis.high, 2);
}

}  // namespace

void draw_horizontal(Svg& svg, const Box& plot, const Axis& axis, Edge edge, const Rich& title, int count) {
  const bool top = edge == Edge::top;
  const double y = top ? plot.y : plot.bottom();
  const double out = top ? -1.0 : 1.0;
  for (const Tick& tick : ticks_that_fit(axis, count)) {
    const double x = axis(tick.value);
    svg.line({x, plot.y}, {x, plot.bottom()}, grid_pen);
    svg.line({x, y}, {x, y + out * tick_length}, tick_pen);
    const double base =
        top ? y - tick_length - label_gap : y + tick_length + label_gap + 0.7 * tick_label_size;
    svg.text({x, base}, plain(tick.label), {.size = tick_label_size, .anchor = Anchor::middle});
  }
  const double away = tick_length + 2.2 * label_gap + tick_label_size;
  svg.text({plot.x + 0.5 * plot.width, top ? y - away - 1.0 : y + away + 0.8 * axis_title_size}, title,
           {.size = axis_title_size, .anchor = Anchor::middle});
}

void draw_vertical(Svg& svg, const Box& plot, const Axis& axis, const Rich& title, int count) {
  double widest = 0.0;
  for (const Tick& tick : ticks(axis.low, axis.high, count)) {
    const double y = axis(tick.value);
    svg.line({plot.x, y}, {plot.right(), y}, grid_pen);
    svg.line({plot.x - tick_length, y}, {plot.x, y}, tick_pen);
    svg.text({plot.x - tick_length - 2.0, y + 0.36 * tick_label_size}, plain(tick.label),
             {.size = tick_label_size, .anchor = Anchor::end});
    widest = std::max(widest, width(plain(tick.label), tick_label_size));
  }
  svg.text({plot.x - tick_length - 2.0 - widest - label_gap, plot.y + 0.5 * plot.height}, title,
           {.size = axis_title_size, .anchor = Anchor::middle, .upward = true});
}

}  // namespace cpt::drawing

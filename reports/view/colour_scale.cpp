#include "reports/view/colour_scale.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::reports::view {
namespace {

using drawing::number, drawing::Range, drawing::Tick, drawing::widened;

// Weight beyond the ends of a scale.
constexpr double weight_below = 0.01, weight_above = 0.005, weight_above_log = 0.001;

// 1, 2 or 5 times a power of ten, the next one at or beyond the value. Wants value > 0.
double round_down(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double ratio = value / power * (1.0 + 1e-9);
  return power * (ratio >= 5.0 ? 5.0 : ratio >= 2.0 ? 2.0 : 1.0);
}
double round_up(double value) {
  const double down = round_down(value);
  if (value <= down * (1.0 + 1e-9)) return down;
  return round_down(down * 2.5001);
}

struct Ends {
  double low, high;
};

// The values beyond which these shares of the weight lie. Wants values, rising.
Ends ends_of(const std::vector<Weighted>& values, double share_below, double share_above) {
  double whole = 0.0;
  for (const Weighted& one : values) whole += one.weight;
  const auto at = [&](double share) {
    double sum = 0.0;
    for (const Weighted& one : values)
      if ((sum += one.weight) >= share * whole) return one.value;
    return values.back().value;
  };
  return {at(share_below), at(1.0 - share_above)};
}

// Moves the ends outward to multiples of a fifth of the range or so.
Ends rounded(Ends ends) {
  if (!(ends.high > ends.low)) {
    const Range range = widened(ends.low, ends.high, 0.0);
    ends = {range.low, range.high};
  }
  const double step = round_down((ends.high - ends.low) / 5.0);
  return {step * std::floor(ends.low / step + 1e-9), step * std::ceil(ends.high / step - 1e-9)};
}

}  // namespace

double ColourScale::place(double value) const {
  if (std::isnan(value)) return value;
  const double at = kind == ScaleKind::log ? value <= low ? 0.0 : std::log(value / low) / std::log(high / low)
                                           : (value - low) / (high - low);
  return std::clamp(at, 0.0, 1.0);
}

Colour ColourScale::operator()(double value) const {
  const double at = place(value);
  return std::isnan(at) ? no_value : shade_at(map, at);
}

std::vector<Tick> ColourScale::ticks(int count) const {
  if (kind != ScaleKind::log) return drawing::ticks(low, high, count);
  std::vector<Tick> all, decades;
  for (double value = round_up(low); value <= high * (1.0 + 1e-9); value = round_up(value * 1.0001)) {
    all.push_back({value, number(value, 1)});
    if (std::abs(std::log10(value) - std::round(std::log10(value))) < 1e-6) decades.push_back(all.back());
  }
  return all.size() <= static_cast<std::size_t>(count) || decades.size() < 2 ? all : decades;
}

ColourScale fitted(ColourMap map, ScaleKind kind, std::vector<Weighted> values) {
  const bool log = kind == ScaleKind::log;
  std::erase_if(values, [&](const Weighted& one) {
    return !std::isfinite(one.value) || !(one.weight > 0.0) || (log && one.value <= 0.0);
  });
  if (values.empty())
    return {map, kind, kind == ScaleKind::diverging ? -1.0 : log ? 1.0 : 0.0, log ? 10.0 : 1.0};
  std::ranges::sort(values, {}, &Weighted::value);
  Ends ends = ends_of(values, weight_below, log ? weight_above_log : weight_above);
  if (log) {
    ends = {round_down(ends.low), round_up(ends.high)};
    if (ends.high <= ends.low) ends.high = 10.0 * ends.low;
  } else if (kind == ScaleKind::diverging) {
    const double far = std::max({std::abs(ends.low), std::abs(ends.high), 1e-12});
    ends.high = rounded({0.0, far}).high;
    ends.low = -ends.high;
  } else if (kind == ScaleKind::from_zero) {
    ends = {0.0, rounded({0.0, std::max(ends.high, 1e-12)}).high};
  } else {
    ends = rounded(ends);
  }
  return {map, kind, ends.low, ends.high};
}

}  // namespace cpt::reports::view

#include "recordings/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "recordings/text.hpp"

namespace cpt::recordings {
namespace {

struct Unit {
  Dimension dimension;
  std::string_view label;  // in lower case
  double scale;
};

constexpr double degree = std::numbers::pi / 180.0;  // [rad]
constexpr Unit units[] = {
    {Dimension::pressure, "mpa", 1e6},    {Dimension::pressure, "mn/m2", 1e6},
    {Dimension::pressure, "n/mm2", 1e6},  {Dimension::pressure, "kpa", 1e3},
    {Dimension::pressure, "kn/m2", 1e3},  {Dimension::pressure, "pa", 1.0},
    {Dimension::pressure, "n/m2", 1.0},   {Dimension::pressure, "bar", 1e5},
    {Dimension::length, "m", 1.0},        {Dimension::length, "cm", 1e-2},
    {Dimension::length, "mm", 1e-3},      {Dimension::angle, "degrees", degree},
    {Dimension::angle, "degree", degree}, {Dimension::angle, "deg", degree},
    {Dimension::angle, "\u00b0", degree}, {Dimension::angle, "graden(deg)", degree},
    {Dimension::angle, "graden", degree}, {Dimension::angle, "rad", 1.0},
    {Dimension::time, "s", 1.0},          {Dimension::time, "sec", 1.0},
    {Dimension::time, "ms", 1e-3},        {Dimension::time, "min", 60.0},
    {Dimension::speed, "m_per_s", 1.0},   {Dimension::speed, "m/s", 1.0},
    {Dimension::speed, "cm/s", 1e-2},     {Dimension::speed, "mm_per_s", 1e-3},
    {Dimension::speed, "mm/s", 1e-3},     {Dimension::area, "m2", 1.0},
    {Dimension::area, "cm2", 1e-4},       {Dimension::area, "mm2", 1e-6},
};

std::string normal(std::string_view label) {
  const std::string lower = lower_case(trimmed(label));
  constexpr std::string_view square = "\u00b2";
  const std::size_t at = std::min(lower.find(square), lower.size());
  std::string text = lower.substr(0, at);
  if (at == lower.size()) return text;
  text += '2';
  text += lower.substr(at + square.size());
  return text;
}

}  // namespace

std::optional<double> scale_of(Dimension dimension, std::string_view label) {
  const std::string text = normal(label);
  for (const Unit& unit : units)
    if (unit.dimension == dimension && unit.label == text) return unit.scale;
  return std::nullopt;
}

double unit_of(const UnitLabel& unit, Recording& recording) {
  const double standard = scale_of(unit.dimension, unit.standard).value();
  const auto scale = scale_of(unit.dimension, unit.label);
  const Lines lines{0, unit.line, unit.line};
  const std::string found = fmt::format("unit of {} is {}", unit.what, in_quotes(unit.label));
  if (!scale)
    recording.remarks.push_back({lines, found, fmt::format("read as {}", unit.standard),
                                 "it is no unit of this quantity; the format prescribes this one"});
  else if (*scale != standard)
    recording.remarks.push_back({lines, found, "read as the label says",
                                 fmt::format("the format prescribes {}; look at the values", unit.standard)});
  else if (unit.dimension == Dimension::pressure && unit.label != unit.standard)
    recording.remarks.push_back(
        {lines, found, fmt::format("read as {}", unit.standard), "the same unit by another spelling"});
  return scale.value_or(standard);
}

}  // namespace cpt::recordings

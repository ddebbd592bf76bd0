#include "recordings/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "recordings/text.hpp"

namespace cpt::recordings {
namespace {

struct Unit {
  Dimension dimension;
  std::string_view label;  // in lower case
  double scale;
};

constexpr double kgf = 9.80665;                 // [N]
constexpr double lbf = 4.4482216152605;         // [N]
constexpr double foot = 0.3048, inch = 0.0254;  // [m]
using enum Dimension;
constexpr Unit known_labels[] = {
    {pressure, "mpa", 1e6},
    {pressure, "mn/m2", 1e6},
    {pressure, "kpa", 1e3},
    {pressure, "kn/m2", 1e3},
    {pressure, "pa", 1.0},
    {pressure, "bar", 1e5},
    {pressure, "kgf/cm2", kgf * 1e4},
    {pressure, "psi", lbf / (inch * inch)},
    {pressure, "n/mm2", 1e6},
    {pressure, "n/m2", 1.0},
    {pressure, "mnm-2", 1e6},
    {pressure, "knm-2", 1e3},
    {pressure, "nmm-2", 1e6},
    {pressure, "nm-2", 1.0},
    {pressure, "gpa", 1e9},
    {pressure, "hpa", 1e2},
    {pressure, "mbar", 1e2},
    {pressure, "megapascal", 1e6},
    {pressure, "kilopascal", 1e3},
    {pressure, "pascal", 1.0},
    {pressure, "kg/cm2", kgf * 1e4},
    {pressure, "t/m2", kgf * 1e3},
    {pressure, "tf/m2", kgf * 1e3},
    {pressure, "ksi", 1e3 * lbf / (inch * inch)},
    {pressure, "ksf", 1e3 * lbf / (foot * foot)},
    {pressure, "tsf", 2e3 * lbf / (foot * foot)},
    {pressure, "atm", 101325.0},
    {length, "m", 1.0},
    {length, "cm", 1e-2},
    {length, "mm", 1e-3},
    {length, "ft", foot},
    {length, "dm", 1e-1},
    {length, "meter", 1.0},
    {length, "metre", 1.0},
    {length, "meters", 1.0},
    {length, "metres", 1.0},
    {length, "centimeter", 1e-2},
    {length, "millimeter", 1e-3},
    {length, "feet", foot},
    {length, "in", inch},
    {angle, "deg", degree},
    {angle, "degrees", degree},
    {angle, "rad", 1.0},
    {angle, "degree", degree},
    {angle, "\u00b0", degree},
    {angle, "\u00ba", degree},  // the sign of an ordinal number
    {angle, "\u02da", degree},  // a ring above
    {angle, "graden", degree},
    {angle, "graad", degree},
    {angle, "radians", 1.0},
    {time, "s", 1.0},
    {time, "ms", 1e-3},
    {time, "min", 60.0},
    {time, "h", 3600.0},
    {time, "sec", 1.0},
    {time, "secs", 1.0},
    {time, "second", 1.0},
    {time, "seconds", 1.0},
    {time, "seconde", 1.0},
    {time, "seconden", 1.0},
    {time, "minute", 60.0},
    {time, "minutes", 60.0},
    {speed, "m/s", 1.0},
    {speed, "cm/s", 1e-2},
    {speed, "mm/s", 1e-3},
    {speed, "m_per_s", 1.0},
    {speed, "cm_per_s", 1e-2},
    {speed, "mm_per_s", 1e-3},
    {speed, "cm/sec", 1e-2},
    {speed, "mm/sec", 1e-3},
    {speed, "m/min", 1.0 / 60.0},
    {area, "m2", 1.0},
    {area, "cm2", 1e-4},
    {area, "mm2", 1e-6},
    {area, "vierkantemillimeter", 1e-6},
    {area, "squaremillimetre", 1e-6},
};

/// What says "no unit" where one should stand.
constexpr std::string_view no_units[] = {"",     "-",   "--",  "?",  "1",        "geen",
                                         "none", "n/a", "nvt", "na", "onbekend", "unknown"};

/// Lower case; squares as "2"; without blanks, points and signs of multiplication.
std::string normal_spelling(std::string_view label) {
  struct Spelling {
    std::string_view part, instead;
  };
  static constexpr Spelling spellings[] = {{"\u00b2", "2"}, {"\u207b", "-"}, {"\u2212", "-"}, {" ", ""},
                                           {"\t", ""},      {"\u00a0", ""},  {"^", ""},       {"*", ""},
                                           {"\u00b7", ""},  {"\u22c5", ""},  {".", ""}};
  const std::string lower = lower_case(label);
  std::string text;
  for (std::string_view rest = lower; !rest.empty();) {
    const auto* found = std::find_if(std::begin(spellings), std::end(spellings),
                                     [&](const Spelling& s) { return rest.starts_with(s.part); });
    const bool other = found != std::end(spellings);
    text += other ? found->instead : rest.substr(0, 1);
    rest.remove_prefix(other ? found->part.size() : 1);
  }
  return text;
}

std::optional<double> scale_of_word(Dimension dimension, std::string_view label) {
  const std::string text = normal_spelling(label);
  for (const Unit& unit : known_labels)
    if (unit.dimension == dimension && unit.label == text) return unit.scale;
  return std::nullopt;
}

}  // namespace

std::optional<double> scale_of(Dimension dimension, std::string_view label) {
  if (const auto whole = scale_of_word(dimension, label)) return whole;
  // "MPa (megaPascal)", "[kPa]": the unit, its name in brackets, or both
  const std::size_t open = label.find_first_of("([");
  const std::size_t close = label.find_last_of(")]");
  if (open == label.npos || close == label.npos || close < open) return std::nullopt;
  const auto before = scale_of_word(dimension, label.substr(0, open));
  const auto inside = scale_of_word(dimension, label.substr(open + 1, close - open - 1));
  if (before && inside && *before != *inside) return std::nullopt;
  return before || !trimmed(label.substr(0, open)).empty() ? before : inside;
}

std::optional<double> unit_of(const UnitLabel& unit, Recording& recording) {
  const double standard = scale_of(unit.dimension, unit.standard).value();
  const auto scale = scale_of(unit.dimension, unit.label);
  const Lines lines{0, unit.line, unit.line};
  const std::string found = fmt::format("unit of {} is {}", unit.what, in_quotes(unit.label));
  const bool none =
      std::find(std::begin(no_units), std::end(no_units), normal_spelling(unit.label)) != std::end(no_units);
  if (!scale && !none) return std::nullopt;
  if (!scale)
    recording.remarks.push_back(
        {lines, found, fmt::format("read as {}", unit.standard), "the format prescribes this one"});
  else if (*scale != standard)
    recording.remarks.push_back({lines, found, "read as the label says",
                                 fmt::format("the format prescribes {}; look at the values", unit.standard)});
  else if (unit.dimension == Dimension::pressure &&
           trimmed(unit.label.substr(0, unit.label.find('('))) != unit.standard)
    recording.remarks.push_back(
        {lines, found, fmt::format("read as {}", unit.standard), "the same unit by another spelling"});
  return scale.value_or(standard);
}

std::string_view known_units(Dimension dimension) {
  switch (dimension) {
    case Dimension::pressure:
      return "MPa, kPa, Pa, MN/m2, kN/m2, bar, kgf/cm2, psi";
    case Dimension::length:
      return "m, cm, mm, ft";
    case Dimension::angle:
      return "degrees, rad";
    case Dimension::time:
      return "s, ms, min, h";
    case Dimension::speed:
      return "m/s, cm/s, mm/s";
    case Dimension::area:
      break;
  }
  return "m2, cm2, mm2";
}

}  // namespace cpt::recordings

// Makes the entries of the list of quantities from pointers to members of Setup.
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "solver/quantities.hpp"

namespace cpt::solver {

struct Unit {
  std::string_view text;
  double scale;  // SI value = scale * study value
};
inline constexpr Unit none{"-", 1.0};
inline constexpr Unit percent{"%", 0.01};
inline constexpr Unit degrees{"deg", std::numbers::pi / 180.0};
inline constexpr Unit kilopascals{"kPa", 1.0e3};
inline constexpr Unit metres{"m", 1.0};
inline constexpr Unit millimetres{"mm", 1.0e-3};
inline constexpr Unit millimetres_per_megapascal{"mm/MPa", 1.0e-9};
inline constexpr Unit kilopascals_per_metre{"kPa/m", 1.0e3};
inline constexpr Unit per_second{"1/s", 1.0};
inline constexpr Unit metres_per_second{"m/s", 1.0};
inline constexpr Unit kilograms_per_cubic_metre{"kg/m3", 1.0};

inline constexpr std::optional<Soil> sand_only = Soil::sand;
inline constexpr std::optional<Soil> clay_only = Soil::clay;
inline constexpr std::optional<Soil> any_soil = std::nullopt;

/// The member at the end of a path of member pointers.
template <auto First, auto... Rest, class Object>
auto& follow(Object& object) {
  if constexpr (sizeof...(Rest) == 0)
    return object.*First;
  else
    return follow<Rest...>(object.*First);
}

template <auto... Path>
double get_field(const Setup& setup) {
  return static_cast<double>(follow<Path...>(setup));
}

template <auto... Path>
void set_field(Setup& setup, double value) {
  auto& field = follow<Path...>(setup);
  using Field = std::remove_reference_t<decltype(field)>;
  if constexpr (std::is_same_v<Field, double>)
    field = value;
  else
    field = static_cast<Field>(std::lround(value));
}

/// A number; min and max in study units.
template <auto... Path>
Quantity number(std::string_view name, std::string_view symbol, Unit unit, double min, double max,
                std::optional<Soil> soil, std::string_view meaning, std::string_view source) {
  using Field = std::remove_cvref_t<decltype(follow<Path...>(std::declval<Setup&>()))>;
  return {
      name,    symbol, unit.text,          unit.scale,        min, max, {}, std::is_integral_v<Field>, soil,
      meaning, source, get_field<Path...>, set_field<Path...>};
}

/// One of several named alternatives, in the order of the field's values.
template <auto... Path>
Quantity choice(std::string_view name, std::string_view symbol, std::vector<std::string_view> choices,
                std::optional<Soil> soil, std::string_view meaning, std::string_view source) {
  const double last = static_cast<double>(choices.size() - 1);
  return {name,    symbol, none.text,          none.scale,        0.0, last, std::move(choices), false, soil,
          meaning, source, get_field<Path...>, set_field<Path...>};
}

}  // namespace cpt::solver

// Makes the entries of the list of quantities from pointers to members of Setup.
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "solver/quantities.hpp"
#include "solver/soils/law.hpp"
#include "solver/units.hpp"

namespace cpt::solver {

inline constexpr ActsOn any_soil = nullptr;
/// Soils of the law of these parameters.
template <class Parameters>
bool of_law(const Law& law) {
  return &law == &Parameters::law();
}
inline constexpr ActsOn norsand_only = of_law<NorSandParameters>;
inline constexpr ActsOn tresca_only = of_law<TrescaParameters>;

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
                ActsOn acts_on, std::string_view meaning, std::string_view source) {
  using Field = std::remove_cvref_t<decltype(follow<Path...>(std::declval<Setup&>()))>;
  return {std::string(name),
          std::string(symbol),
          unit.text,
          unit.scale,
          min,
          max,
          {},
          std::is_integral_v<Field>,
          "",
          acts_on,
          meaning,
          source,
          get_field<Path...>,
          set_field<Path...>};
}

/// One of several named alternatives, in the order of the field's values.
template <auto... Path>
Quantity choice(std::string_view name, std::string_view symbol, std::vector<std::string_view> choices,
                ActsOn acts_on, std::string_view meaning, std::string_view source) {
  const double last = static_cast<double>(choices.size() - 1);
  return {std::string(name),
          std::string(symbol),
          none.text,
          none.scale,
          0.0,
          last,
          std::move(choices),
          false,
          "",
          acts_on,
          meaning,
          source,
          get_field<Path...>,
          set_field<Path...>};
}

}  // namespace cpt::solver

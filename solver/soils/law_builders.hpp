// Makes the entries of a law's list of parameters from pointers to their members.
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>

#include "solver/soils/law.hpp"
#include "solver/units.hpp"

namespace cpt::solver {

template <class Parameters, auto Member>
double get_parameter(const LawParameters& parameters) {
  return static_cast<double>(std::get<Parameters>(parameters).*Member);
}

template <class Parameters, auto Member>
void set_parameter(LawParameters& parameters, double value) {
  auto& field = std::get<Parameters>(parameters).*Member;
  using Field = std::remove_reference_t<decltype(field)>;
  if constexpr (std::is_same_v<Field, double>)
    field = value;
  else
    field = static_cast<Field>(std::lround(value));
}

/// A number; min and max in study units.
template <class Parameters, auto Member>
LawQuantity parameter(std::string_view name, std::string_view symbol, Unit unit, double min, double max,
                      std::string_view meaning, std::string_view source) {
  return {name,
          symbol,
          unit.text,
          unit.scale,
          min,
          max,
          {},
          meaning,
          source,
          get_parameter<Parameters, Member>,
          set_parameter<Parameters, Member>};
}

/// One of several named alternatives, in the order of the field's values.
template <class Parameters, auto Member>
LawQuantity alternative(std::string_view name, std::string_view symbol, std::vector<std::string_view> choices,
                        std::string_view meaning, std::string_view source) {
  const double last = static_cast<double>(choices.size() - 1);
  return {name,
          symbol,
          none.text,
          none.scale,
          0.0,
          last,
          std::move(choices),
          meaning,
          source,
          get_parameter<Parameters, Member>,
          set_parameter<Parameters, Member>};
}

}  // namespace cpt::solver

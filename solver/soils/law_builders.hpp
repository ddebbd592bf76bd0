// Makes the entries of a law's list of parameters from pointers to their members.
#pragma once

#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "solver/soils/law.hpp"
#include "solver/soils/random_field.hpp"
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

/// What a random field of one of a law's parameters consists of; named after the parameter, whose unit its
/// deviation has. `most` is the largest deviation in that unit.
template <class Parameters, auto Field>
std::vector<LawQuantity> field_of(std::string_view deviation, std::string_view length, std::string_view kind,
                                  std::string_view seed, Unit unit, double most) {
  constexpr std::string_view source =
      "Vanmarcke (1983), section 5.1; Phoon & Kulhawy (1999) for usual values";
  const auto part = []<auto Member>() {
    return std::pair<double (*)(const LawParameters&), void (*)(LawParameters&, double)>{
        [](const LawParameters& p) { return static_cast<double>((std::get<Parameters>(p).*Field).*Member); },
        [](LawParameters& p, double value) {
          auto& field = (std::get<Parameters>(p).*Field).*Member;
          using Type = std::remove_reference_t<decltype(field)>;
          if constexpr (std::is_same_v<Type, double>)
            field = value;
          else
            field = static_cast<Type>(std::lround(value));
        }};
  };
  const auto deviation_part = part.template operator()<&RandomField::deviation>(),
             length_part = part.template operator()<&RandomField::length>(),
             kind_part = part.template operator()<&RandomField::kind>(),
             seed_part = part.template operator()<&RandomField::seed>();
  return {{deviation,
           "σ_field",
           unit.text,
           unit.scale,
           0.0,
           most,
           {},
           "standard deviation of its random field over depth; 0: it is uniform",
           source,
           deviation_part.first,
           deviation_part.second,
           false,
           true},
          {length,
           "δ_field",
           metres.text,
           metres.scale,
           0.01,
           100.0,
           {},
           "correlation length of that field, half its scale of fluctuation",
           source,
           length_part.first,
           length_part.second,
           false,
           true},
          {kind,
           "field",
           none.text,
           none.scale,
           0.0,
           1.0,
           {"normal", "lognormal"},
           "how the field's values are distributed",
           source,
           kind_part.first,
           kind_part.second,
           false,
           true},
          {seed,
           "field",
           none.text,
           none.scale,
           1.0,
           4294967296.0,
           {},
           "which of all such fields it is",
           source,
           seed_part.first,
           seed_part.second,
           true,
           true}};
}

}  // namespace cpt::solver

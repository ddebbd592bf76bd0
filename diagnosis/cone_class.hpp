// What a cone's application class allows it to be wrong by: ISO 22476-1 (2012), Table 2.
#pragma once

#include <array>
#include <numbers>

namespace cpt::diagnosis {

/// Allowed errors [Pa] where they are more than the percentage of the reading.
struct ConeAccuracy {
  double tip, sleeve;
  /// A class asks for a resolution of a third of its accuracy; rounding to that scatters by this share of it.
  static constexpr double scatter = std::numbers::inv_sqrt3 / 6.0;
};

/// Of class 1, 2, 3 or 4.
[[nodiscard]] constexpr ConeAccuracy cone_accuracy(int application_class) {
  constexpr std::array<ConeAccuracy, 4> classes = {
      {{35e3, 5e3}, {100e3, 15e3}, {200e3, 25e3}, {500e3, 50e3}}};
  return classes.at(static_cast<std::size_t>(application_class - 1));
}

}  // namespace cpt::diagnosis

// What of a material point can be looked at.
#pragma once

#include <span>
#include <string_view>

#include "reports/view/colour_scale.hpp"

namespace cpt::reports::view {

struct ViewQuantity {
  std::string_view name;    ///< "p"
  std::string_view symbol;  ///< "p'"
  std::string_view meaning;
  std::string_view unit;   ///< of the picture: "kPa"
  double scale;            ///< SI value of one such unit
  std::string_view array;  ///< of the stored fields, docs/output.md
  /// In SI units, from the array's components.
  double (*value)(std::span<const double> components);
  ColourMap map;
  ScaleKind kind;
};

[[nodiscard]] std::span<const ViewQuantity> view_quantities();
/// nullptr if there is none of this name.
[[nodiscard]] const ViewQuantity* find_view_quantity(std::string_view name);

}  // namespace cpt::reports::view

// Units as files write them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "recordings/recording.hpp"

namespace cpt::recordings {

enum class Dimension { pressure, length, angle, time, speed, area };

/// Factor to SI of a label such as "MPa", "kN/m2", "Graden(deg)"; capitals do not matter. Nothing if it is
/// not one of this dimension.
[[nodiscard]] std::optional<double> scale_of(Dimension dimension, std::string_view label);

/// What a file says of the unit of one of its columns.
struct UnitLabel {
  std::string what;  ///< for the remark: "q_c (column 2)"
  Dimension dimension;
  std::string_view label;     ///< the file's
  std::string_view standard;  ///< the format's; one that scale_of knows
  int line;                   ///< where the label stands
};

/// Factor to SI: the label's if it is a unit of the right kind, else the format's own. A remark tells where
/// the two are not the same word.
[[nodiscard]] double unit_of(const UnitLabel& unit, Recording& recording);

}  // namespace cpt::recordings

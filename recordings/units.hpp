// Units as files write them.
#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "recordings/recording.hpp"

namespace cpt::recordings {

inline constexpr double kPa = 1.0e3, MPa = 1.0e6;           // [Pa]
inline constexpr double degree = std::numbers::pi / 180.0;  // [rad]

enum class Dimension { pressure, length, angle, time, speed, area };

/// Factor to SI of a label such as "MPa", "kN/m\u00b2", "MN/m^2", "MPa (megaPascal)", "Graden(deg)"; capitals
/// and blanks do not matter. Nothing if it is not one of this dimension, or names two units that differ.
[[nodiscard]] std::optional<double> scale_of(Dimension dimension, std::string_view label);

/// What a file says of the unit of one of its columns.
struct UnitLabel {
  std::string what;  ///< for the remark: "q_c (column 2)"
  Dimension dimension;
  std::string_view label;     ///< the file's
  std::string_view standard;  ///< the format's; one that scale_of knows
  int line;                   ///< where the label stands
};

/// Factor to SI: the label's, or the format's own where the file gives none ("", "-", "geen"). Nothing where
/// the label is no unit of this kind. A remark tells where label and format differ.
[[nodiscard]] std::optional<double> unit_of(const UnitLabel& unit, Recording& recording);

/// The usual units of a dimension, for messages.
[[nodiscard]] std::string_view known_units(Dimension dimension);

}  // namespace cpt::recordings

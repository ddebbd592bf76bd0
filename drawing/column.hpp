// The widths at which journals print figures.
#pragma once

namespace cpt::drawing {

/// Columns of Elsevier's journals [mm]: single, one and a half, double.
enum class Column { single = 90, one_and_half = 140, full = 190 };

/// In typographic points.
[[nodiscard]] constexpr double width_of(Column column) { return static_cast<int>(column) / 25.4 * 72.0; }

}  // namespace cpt::drawing

// Small panels of equal size, row by row.
#pragma once

#include <cstddef>

#include "drawing/column.hpp"
#include "drawing/svg.hpp"

namespace cpt::reports::calibrated {

struct PanelGrid {
  std::size_t panels, columns = 3;
  double top = 42.0, height = 96.0;  // [pt] of the heading; of a panel's frame
  static constexpr double left = 44.0, gap_across = 40.0, gap_down = 50.0, right = 14.0, below = 44.0;
  [[nodiscard]] double width() const { return drawing::width_of(drawing::Column::full); }
  [[nodiscard]] double bottom() const {
    const auto rows = static_cast<double>((panels + columns - 1) / columns);
    return top + rows * height + (rows - 1.0) * gap_down + below;
  }
  [[nodiscard]] drawing::Box box(std::size_t k) const {
    const auto across = static_cast<double>(columns);
    const double w = (width() - left - right - (across - 1.0) * gap_across) / across;
    return {left + static_cast<double>(k % columns) * (w + gap_across),
            top + static_cast<double>(k / columns) * (height + gap_down), w, height};
  }
};

}  // namespace cpt::reports::calibrated

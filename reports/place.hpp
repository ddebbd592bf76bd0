// Where a figure stands.
#pragma once

#include "drawing/column.hpp"
#include "drawing/svg.hpp"

namespace cpt::reports {

/// How wide a figure is; in the report's page it has no heading, since the page says itself whose it is.
struct Place {
  drawing::Column column = drawing::Column::one_and_half;
  drawing::Ground ground = drawing::Ground::file;

  Place() = default;
  Place(drawing::Column c, drawing::Ground g = drawing::Ground::file)
      : column(c), ground(g) {}  // NOLINT: meant
};

}  // namespace cpt::reports

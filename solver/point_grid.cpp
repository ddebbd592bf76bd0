#include "solver/point_grid.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {
namespace {

std::vector<PointZone> zones_to_wall(const Setup& setup) {
  std::vector<PointZone> zones;
  double inner = 0.0;
  for (const PointZone& zone : setup.numerics.zones) {
    if (inner >= setup.chamber.radius - 1e-9) break;
    const bool last =
        &zone == &setup.numerics.zones.back() || zone.outer_radius >= setup.chamber.radius - 1e-9;
    PointZone cut = zone;
    if (last) {
      cut.outer_radius = setup.chamber.radius;
      const double spacing = (zone.outer_radius - inner) / zone.columns;
      cut.columns = std::max(1, static_cast<int>(std::lround((cut.outer_radius - inner) / spacing)));
    }
    zones.push_back(cut);
    inner = cut.outer_radius;
  }
  return zones;
}

}  // namespace

std::vector<PointGrid> point_grids(const Setup& setup) {
  const bool layer = setup.chamber.surcharge == SurchargeKind::layer;
  const double top = layer ? setup.chamber.surcharge_height : 0.0, bottom = -setup.chamber.soil_height;
  std::vector<PointGrid> grids;
  double inner = 0.0;
  for (const PointZone& zone : zones_to_wall(setup)) {
    const int rows = static_cast<int>(std::lround((top - bottom) * zone.rows_per_metre));
    const double dr = (zone.outer_radius - inner) / zone.columns, dz = (top - bottom) / rows;
    grids.push_back(
        {inner, zone.outer_radius, zone.columns, rows, bottom, dr, dz, setup.numerics.point_shift});
    inner = zone.outer_radius;
  }
  return grids;
}

}  // namespace cpt::solver

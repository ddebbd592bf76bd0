#include "solver/point_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "solver/hashed.hpp"

namespace cpt::solver {
namespace {

constexpr double rounding = 1e-6;  // [-] of a row
constexpr double touching = 1e-9;  // [m]

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

// Heights from the bottom to the top between which points are alike.
std::vector<double> band_edges(const Setup& setup, double top) {
  const double bottom = -setup.chamber.soil_height;
  std::vector<double> edges = {bottom, 0.0, top};
  const auto add = [&](double depth) {
    if (-depth > bottom && depth > 0.0) edges.push_back(-depth);
  };
  for (const Layer& layer : setup.layers) add(layer.top);
  if (const DensityLens& lens = setup.mechanisms.density_lens; lens.change != 0.0) {
    add(lens.centre + 0.5 * lens.thickness);
    add(lens.centre - 0.5 * lens.thickness);
  }
  std::ranges::sort(edges);
  const auto same = [](double a, double b) { return b - a < touching; };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());  // clang 14 has no ranges::unique
  return edges;
}

}  // namespace

Scatter scatter(double shift, std::uint64_t id) {
  const std::uint64_t seed = hashed(std::bit_cast<std::uint64_t>(shift + 0.0));  // -0 as 0
  const auto off = [](std::uint64_t x) { return farthest_off * (2.0 * hashed_unit(x) - 1.0); };
  return {off(seed + 2 * id), off(seed + 2 * id + 1)};
}

std::vector<PointGrid> point_grids(const Setup& setup) {
  const bool layer = setup.chamber.surcharge == SurchargeKind::layer;
  const std::vector<double> edges = band_edges(setup, layer ? setup.chamber.surcharge_height : 0.0);
  std::vector<PointGrid> grids;
  double inner = 0.0;
  for (const PointZone& zone : zones_to_wall(setup)) {
    PointGrid grid{inner, zone.outer_radius, zone.columns, (zone.outer_radius - inner) / zone.columns, {}};
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      const double height = edges[k + 1] - edges[k];
      const int rows = std::max(1, static_cast<int>(std::ceil(height * zone.rows_per_metre - rounding)));
      grid.bands.push_back({edges[k], rows, height / rows});
    }
    grids.push_back(std::move(grid));
    inner = zone.outer_radius;
  }
  return grids;
}

}  // namespace cpt::solver

#include "solver/initial_state.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::solver {
namespace {

double effective_ratio(SelfWeight kind, double rho) {
  switch (kind) {
    case SelfWeight::none:
      return 0.0;
    case SelfWeight::saturated:
      return 1.0;
    default:
      return (rho - rho_water) / rho;
  }
}

Soil soil_at(const Setup& setup, double depth) {
  for (const Layer& layer : setup.layers)
    if (depth < layer.bottom) return layer.soil;
  return setup.layers.back().soil;
}

// The zones of the setup, cut or stretched to the chamber's wall, columns scaled to keep their spacing.
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

Bulk bulk(const Setup& setup, Soil soil) {
  const bool sand = soil == Soil::sand;
  const double e = sand ? setup.sand.e_max - setup.sand.D_r * (setup.sand.e_max - setup.sand.e_min)
                        : setup.clay.n_0 / (1.0 - setup.clay.n_0);
  const double rho_grains = sand ? setup.sand.rho_grains : setup.clay.rho_grains;
  const double rho = (rho_grains + e * rho_water) / (1.0 + e);
  return {e, rho, effective_ratio(setup.initial.self_weight, rho)};
}

double surcharge_density(const Setup& setup) {
  return setup.initial.sigma_v0 / (gravity * setup.chamber.surcharge_height);
}

double vertical_stress(const Setup& setup, double z) {
  if (z >= 0.0) return std::max(0.0, setup.initial.sigma_v0 * (1.0 - z / setup.chamber.surcharge_height));
  double stress = setup.initial.sigma_v0;
  for (const Layer& layer : setup.layers) {
    const Bulk b = bulk(setup, layer.soil);
    const double thickness = std::min(-z, layer.bottom) - layer.top;
    if (thickness > 0.0) stress += b.rho * b.weight_ratio * gravity * thickness;
  }
  return stress;
}

InitialState initial_state(const Setup& setup, const NorSand* sand) {
  InitialState state;
  const double R_cone = setup.penetrometer.diameter / 2.0;
  const double slope = 1.0 / std::tan(setup.penetrometer.apex / 2.0);
  const double K_0 = setup.initial.sigma_h0 / setup.initial.sigma_v0;
  const bool layer = setup.chamber.surcharge == SurchargeKind::layer;
  const double top = layer ? setup.chamber.surcharge_height : 0.0, bottom = -setup.chamber.soil_height;
  const double shift = setup.numerics.point_shift;

  double id = 0.0;
  double inner = 0.0;
  for (const PointZone& zone : zones_to_wall(setup)) {
    const int rows = static_cast<int>(std::lround((top - bottom) * zone.rows_per_metre));
    const double dr = (zone.outer_radius - inner) / zone.columns, dz = (top - bottom) / rows;
    for (int i = 0; i < zone.columns; ++i) {
      // A shifted grid keeps its outline: the positions move within their own cell of the grid.
      const double r = inner + (i + 0.5 + 0.5 * shift) * dr;
      for (int j = 0; j < rows; ++j, ++id) {
        const double z = bottom + (j + 0.5 + 0.5 * shift) * dz;
        if (r < R_cone && z > (r - R_cone) * slope) continue;  // inside the penetrometer

        const bool in_surcharge = z > 0.0;
        const Soil soil = in_surcharge ? Soil::sand : soil_at(setup, -z);
        const Bulk b = bulk(setup, soil);
        const double sigma_v = vertical_stress(setup, z), sigma_h = K_0 * sigma_v;
        const double volume = r * dr * dz;
        const double rho = in_surcharge ? surcharge_density(setup) : b.rho;
        const bool loaded = !layer && j == rows - 1;
        const double p_i = !in_surcharge && soil == Soil::sand && sand
                               ? sand->initial_image_pressure(-sigma_h, -sigma_v, -sigma_h, 0.0, b.e)
                               : 0.0;
        state.points.push_back({{r, z, 0.0, 0.0, -sigma_h, -sigma_v, -sigma_h, 0.0, rho * volume, volume, b.e,
                                 p_i, 0.0, 0.0, loaded ? setup.initial.sigma_v0 * r * dr : 0.0, id}});
        const Material material = in_surcharge         ? Material::surcharge
                                  : soil == Soil::sand ? Material::sand
                                                       : Material::clay;
        state.material.push_back(static_cast<std::int32_t>(material));
      }
    }
    inner = zone.outer_radius;
  }
  return state;
}

}  // namespace cpt::solver

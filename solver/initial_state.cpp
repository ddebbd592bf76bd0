#include "solver/initial_state.hpp"

#include <algorithm>
#include <cmath>

#include "solver/constitutive/varying_tresca.hpp"
#include "solver/point_grid.hpp"

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

double K_0(const Setup& setup) { return setup.initial.sigma_h0 / setup.initial.sigma_v0; }

Soil soil_at(const Setup& setup, double depth, std::uint64_t id) {
  const InterfaceMixing& mixing = setup.mechanisms.interface_mixing;
  for (std::size_t k = 0; k < setup.layers.size(); ++k) {
    const Layer& layer = setup.layers[k];
    if (depth >= layer.bottom) continue;
    if (!mixing.on()) return layer.soil;
    const bool last = k + 1 == setup.layers.size();
    const double below_top = depth - layer.top, above_bottom = layer.bottom - depth;
    if (k > 0 && below_top < above_bottom)
      return mixing.upper_soil(below_top, id) ? setup.layers[k - 1].soil : layer.soil;
    return last || mixing.upper_soil(-above_bottom, id) ? layer.soil : setup.layers[k + 1].soil;
  }
  return setup.layers.back().soil;
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
    if (thickness <= 0.0) continue;
    const double weight = b.rho * b.weight_ratio * gravity;
    stress =
        setup.mechanisms.wall_friction.below(stress, weight, thickness, K_0(setup), setup.chamber.radius);
  }
  return stress;
}

double horizontal_stress(const Setup& setup, const LeftBehind& left, double z) {
  const double sigma_h = K_0(setup) * vertical_stress(setup, z);
  return z < 0.0 ? sigma_h * left.sigma_h(-z) : sigma_h;
}

double wall_shear(const Setup& setup, const LeftBehind& left, double z) {
  return z < 0.0 ? setup.mechanisms.wall_friction.coefficient * horizontal_stress(setup, left, z) : 0.0;
}

double sand_void_ratio(const Setup& setup, const LeftBehind& left, double depth) {
  const Sand& sand = setup.sand;
  const double e = bulk(setup, Soil::sand).e;
  const double denser =
      setup.mechanisms.surface_compaction.at(depth) + setup.mechanisms.density_lens.at(depth);
  const double change = left.void_ratio(depth) - denser * (sand.e_max - sand.e_min);
  return change == 0.0 ? e : std::clamp(e + change, std::min(e, sand.e_min), std::max(e, sand.e_max));
}

InitialState initial_state(const Setup& setup, const NorSand* sand, const LeftBehind& left) {
  InitialState state;
  const double R_cone = setup.penetrometer.diameter / 2.0;
  const double slope = 1.0 / std::tan(setup.penetrometer.apex / 2.0);
  const bool varying = strength_varies(setup.mechanisms);
  const bool layer = setup.chamber.surcharge == SurchargeKind::layer;

  double id = 0.0;
  for (const PointGrid& grid : point_grids(setup)) {
    for (int i = 0; i < grid.columns; ++i) {
      const double r = grid.r(i);
      for (int j = 0; j < grid.rows; ++j, ++id) {
        const double z = grid.z(j);
        if (r < R_cone && z > (r - R_cone) * slope) continue;  // inside the penetrometer

        const bool in_surcharge = z > 0.0;
        const Soil soil = in_surcharge ? Soil::sand : soil_at(setup, -z, static_cast<std::uint64_t>(id));
        const Bulk b = bulk(setup, soil);
        const bool is_sand = !in_surcharge && soil == Soil::sand, is_clay = soil == Soil::clay;
        const double e = is_sand ? sand_void_ratio(setup, left, -z) : b.e;
        const double sigma_v = vertical_stress(setup, z), sigma_h = horizontal_stress(setup, left, z);
        const double s_rz = wall_shear(setup, left, z) * r / setup.chamber.radius;
        const double volume = r * grid.dr * grid.dz;
        const double rho = in_surcharge ? surcharge_density(setup) : b.rho;
        const bool loaded = !layer && j == grid.rows - 1;
        double p_i = 0.0;
        if (is_sand && sand) p_i = sand->initial_image_pressure(-sigma_h, -sigma_v, -sigma_h, s_rz, e);
        if (is_clay && varying) p_i = strength_at(setup.clay, setup.mechanisms, -z);
        state.points.push_back(
            {{r, z, 0.0, 0.0, -sigma_h, -sigma_v, -sigma_h, s_rz, rho * volume, volume, e, p_i, 0.0, 0.0,
              loaded ? setup.initial.sigma_v0 * r * grid.dr : 0.0, id, 0.0}});
        const Material material = in_surcharge         ? Material::surcharge
                                  : soil == Soil::sand ? Material::sand
                                                       : Material::clay;
        state.material.push_back(static_cast<std::int32_t>(material));
      }
    }
  }
  return state;
}

}  // namespace cpt::solver

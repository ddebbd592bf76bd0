#include "solver/initial_state.hpp"

#include <algorithm>
#include <cmath>

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

std::size_t soil_at(const Setup& setup, double depth, std::uint64_t id) {
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

Bulk bulk(const Setup& setup, std::size_t soil) {
  const LawParameters& parameters = setup.soils[soil].parameters;
  const Law& law = law_of(setup.soils[soil]);
  const double e = law.void_ratio(parameters);
  const double rho = (law.grain_density(parameters) + e * rho_water) / (1.0 + e);
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
  double sigma_h = K_0(setup) * vertical_stress(setup, z);
  if (const StressRatioTrend& trend = setup.mechanisms.stress_ratio_trend; trend.on() && z < 0.0)
    sigma_h *= trend.at(-z, setup.penetrometer.final_depth);
  return z < 0.0 ? sigma_h * left.sigma_h(-z) : sigma_h;
}

double wall_shear(const Setup& setup, const LeftBehind& left, double z) {
  return z < 0.0 ? setup.mechanisms.wall_friction.coefficient * horizontal_stress(setup, left, z) : 0.0;
}

InitialState initial_state(const Setup& setup, std::span<const std::unique_ptr<const SoilModel>> soils,
                           const LeftBehind& left) {
  InitialState state;
  const double R_cone = setup.penetrometer.diameter / 2.0;
  const double slope = 1.0 / std::tan(setup.penetrometer.apex / 2.0);
  const bool layer = setup.chamber.surcharge == SurchargeKind::layer;
  constexpr double surcharge_void_ratio = 0.7;  // [-] it does not matter to an elastic layer

  double id = 0.0;
  for (const PointGrid& grid : point_grids(setup)) {
    for (int i = 0; i < grid.columns; ++i) {
      const double column_r = grid.r(i);
      for (const PointBand& band : grid.bands)
        for (int j = 0; j < band.rows; ++j, ++id) {
          const Scatter off = scatter(setup.numerics.point_shift, static_cast<std::uint64_t>(id));
          const double r = column_r + off.r * grid.dr, z = grid.z(band, j) + off.z * band.dz;
          if (r < R_cone && z > (r - R_cone) * slope) continue;  // inside the penetrometer

          const double sigma_v = vertical_stress(setup, z), sigma_h = horizontal_stress(setup, left, z);
          const double s_rz = wall_shear(setup, left, z) * r / setup.chamber.radius;
          const double volume = column_r * grid.dr * band.dz;
          const bool loaded = !layer && &band == &grid.bands.back() && j == band.rows - 1;
          std::size_t material = setup.soils.size();
          double rho = surcharge_density(setup), e = surcharge_void_ratio;
          PointHistory history{};
          if (z <= 0.0) {
            material = soil_at(setup, -z, static_cast<std::uint64_t>(id));
            const Soil& soil = setup.soils[material];
            rho = bulk(setup, material).rho;
            e = law_of(soil).void_ratio_at(setup, soil.parameters, left, -z);
            if (material < soils.size() && soils[material])
              history = soils[material]->start({-z, -sigma_h, -sigma_v, -sigma_h, s_rz, e});
          }
          state.points.push_back(
              {r, z, 0.0, 0.0, -sigma_h, -sigma_v, -sigma_h, s_rz, rho * volume, volume, e, history[0], 0.0,
               0.0, loaded ? setup.initial.sigma_v0 * column_r * grid.dr : 0.0, id, history[1]});
          state.material.push_back(static_cast<std::int32_t>(material));
        }
    }
  }
  return state;
}

}  // namespace cpt::solver

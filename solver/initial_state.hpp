// The state before the push: material points in radial zones, K0 stresses with self-weight.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/material_points.hpp"
#include "solver/setup.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {

inline constexpr double rho_water = 1000.0;  // [kg/m3]
inline constexpr double gravity = 9.81;      // [m/s2]

/// Bulk properties of a soil before the push.
struct Bulk {
  double e;             // [-] void ratio
  double rho;           // [kg/m3] saturated density
  double weight_ratio;  // [-] effective over total unit weight, by Setup::initial.self_weight
};
/// Of the soil at this place in Setup::soils.
[[nodiscard]] Bulk bulk(const Setup& setup, std::size_t soil);

/// Density of the surcharge layer that gives sigma_v0 at the soil's top [kg/m3].
[[nodiscard]] double surcharge_density(const Setup& setup);

/// Vertical effective stress [Pa], compression-positive, at height z above the soil's top (negative below
/// it), less what wall friction takes.
[[nodiscard]] double vertical_stress(const Setup& setup, double z);
/// Horizontal effective stress [Pa], compression-positive: K_0 times the vertical one, changed by an earlier
/// push.
[[nodiscard]] double horizontal_stress(const Setup& setup, const LeftBehind& left, double z);
/// Shear stress of the soil on the wall [Pa] at height z, downward positive; 0 without wall friction.
[[nodiscard]] double wall_shear(const Setup& setup, const LeftBehind& left, double z);

struct InitialState {
  std::vector<Point> points;
  std::vector<std::int32_t> material;  // number of each point's soil; that after the last is the surcharge
};

/// Points on the grids of the radial zones, but for those inside the penetrometer. Points of soils without a
/// model keep no state.
[[nodiscard]] InitialState initial_state(const Setup& setup,
                                         std::span<const std::unique_ptr<const SoilModel>> soils,
                                         const LeftBehind& left = {});

}  // namespace cpt::solver

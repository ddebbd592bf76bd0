// The state before the push: material points in radial zones, K0 stresses with self-weight.
#pragma once

#include <cstdint>
#include <vector>

#include "solver/constitutive/norsand.hpp"
#include "solver/material_points.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

inline constexpr double rho_water = 1000.0;  // [kg/m3]
inline constexpr double gravity = 9.81;      // [m/s2]

/// Bulk properties of a soil before the push.
struct Bulk {
  double e;             // [-] void ratio
  double rho;           // [kg/m3] saturated density
  double weight_ratio;  // [-] effective over total unit weight, by Setup::initial.self_weight
};
[[nodiscard]] Bulk bulk(const Setup& setup, Soil soil);

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
/// Void ratio of the sand [-] at a depth [m], mechanisms included; between e_min and e_max where they act.
[[nodiscard]] double sand_void_ratio(const Setup& setup, const LeftBehind& left, double depth);

struct InitialState {
  std::vector<Point> points;
  std::vector<std::int32_t> material;  // Material of each point
};

/// Points on the grids of the radial zones, but for those inside the penetrometer.
[[nodiscard]] InitialState initial_state(const Setup& setup, const NorSand* sand,
                                         const LeftBehind& left = {});

}  // namespace cpt::solver

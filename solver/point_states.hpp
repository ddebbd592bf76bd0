// Material points as an observer sees them: copies, one struct a point, whatever the store's layout.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/material_points.hpp"

namespace cpt::solver {

/// A material point at one moment of the push.
struct PointState {
  std::int64_t id = -1;       // permanent number, the same in every push of a layout
  std::int32_t material = 0;  // number of its soil, after the last the surcharge
  bool surcharge = false;
  double r = 0.0, z = 0.0;                                // [m] position; z is upward from the soil's top
  double v_r = 0.0, v_z = 0.0;                            // [m/s] velocity
  double s_rr = 0.0, s_zz = 0.0, s_tt = 0.0, s_rz = 0.0;  // [Pa] Cauchy stress, tension-positive
  double volume = 0.0;                                    // [m3] of the whole ring
  double e = 0.0;                                         // [-] void ratio; NaN in the surcharge
  double h_0 = 0.0, h_1 = 0.0;                            // state variables of the soil's law

  /// Mean stress [Pa], compression-positive.
  [[nodiscard]] double p() const { return -(s_rr + s_zz + s_tt) / 3.0; }
  /// Deviatoric stress sqrt(3 J_2) [Pa].
  [[nodiscard]] double q() const {
    const double d_rr = s_rr + p(), d_zz = s_zz + p(), d_tt = s_tt + p();
    return std::sqrt(1.5 * (d_rr * d_rr + d_zz * d_zz + d_tt * d_tt + 2.0 * s_rz * s_rz));
  }
};

/// All material points, by rising id.
[[nodiscard]] std::vector<PointState> point_states(const MaterialPoints& points);

/// The points with these ids, in their order. Ids that no point has give nothing.
[[nodiscard]] std::vector<PointState> point_states(const MaterialPoints& points,
                                                   std::span<const std::int64_t> ids);

}  // namespace cpt::solver

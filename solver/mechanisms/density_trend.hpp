// Sand that is denser or looser with depth, as raining it from a height that changes leaves it.
//
//   D_r(z) = D_r + difference (z - z_mid) / z_final,  z_mid = z_final / 2
//
// The mean over the push stays. As with surface compaction the self-weight stays that of the mean density.
#pragma once

namespace cpt::solver {

struct DensityTrend {
  double difference = 0.0;  // [-] of the relative density, at the push's final depth less at the top
  double over = 0.0;        // [m] no input: z_final where another push comes first; 0: that of the push

  [[nodiscard]] bool on() const { return difference != 0.0; }
  /// Change of the relative density [-] at a depth [m].
  [[nodiscard]] double at(double depth, double final_depth) const {
    return on() ? difference * (depth / (over > 0.0 ? over : final_depth) - 0.5) : 0.0;
  }
};

}  // namespace cpt::solver

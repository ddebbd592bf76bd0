// An earlier push nearby: its stress and void ratio, found by simulating it, are the start of this one.
//
// The first push runs in the same chamber. At `spacing` from its axis, about where this
// push goes, it leaves sigma'_h(z) / sigma'_h0, e(z) - e_0 and a mean sigma'_v / sigma'_v0 (Yost et al. 2023,
// section 6.3, which takes one number for each). This push starts with `share` of these changes, the same all
// around its own axis. The soil that decides its q_c lies on both sides of that axis, and nearer to the first
// push the change is larger: a spacing below that of the axes stands for it. Vertical equilibrium allows one
// factor on sigma'_v only, horizontal equilibrium any function of depth.
#pragma once

#include <vector>

namespace cpt::solver {

struct PreviousPush {
  double share = 0.0;     // [-] of the change that the first push leaves behind
  double spacing = 0.26;  // [m] between the axes
  // What part of it is taken over; 0 and 1 tell the one effect from the other.
  double stress_share = 1.0;      // [-] of the changed stress
  double void_ratio_share = 1.0;  // [-] of the changed void ratio
  double depth = 0.0;             // [m] of the first push; 0: that of this one

  [[nodiscard]] bool on() const { return share != 0.0; }
};

/// What a push leaves behind at one distance from its axis, by depth bins of equal height.
struct LeftBehind {
  double bin = 0.02;                      // [m]
  std::vector<double> sigma_h_ratio;      // [-] over the initial one
  std::vector<double> void_ratio_change;  // [-]
  double sigma_v_ratio = 1.0;             // [-]

  /// Linear between the middles of the bins, constant beyond the first and last. 1 and 0 without bins.
  [[nodiscard]] double sigma_h(double depth) const;
  [[nodiscard]] double void_ratio(double depth) const;
};

}  // namespace cpt::solver

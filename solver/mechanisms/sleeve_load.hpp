// Part of the sleeve's friction reaches the load cell of the tip, as through a joint that dirt has filled.
//
//   q_recorded = q_c + share f_s A_s / A_c,  f_recorded = (1 - share) f_s,  A_s / A_c = 4 L_sleeve / d
//
// The force on tip and sleeve together, q_c A_c + f_s A_s, is recorded as it is.
#pragma once

namespace cpt::solver {

struct Penetrometer;
struct DepthProfile;

struct SleeveLoad {
  double share = 0.0;  // [-] of the sleeve's force that the tip's cell carries

  [[nodiscard]] bool on() const { return share != 0.0; }
  /// Changes q_c and f_s where both were measured.
  void apply(DepthProfile& profile, const Penetrometer& penetrometer) const;
};

}  // namespace cpt::solver

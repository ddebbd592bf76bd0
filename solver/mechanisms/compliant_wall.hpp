// A chamber wall that gives way: a gap that closes at the initial stress, then a stiffness.
//
//   sigma_r(wall) = sigma'_h0 + max(0, u - gap) / compliance,  u = outward displacement of the soil at the
//   wall
//
// Yost et al. (2023), section 3.1, name the rigid and the constant-stress wall as the limits: compliance 0
// and infinity (with gap 0). Stability: the wall's spring on the mass next to it, dt < 2 sqrt(compliance rho
// f w / 2), is far above the soil's own step for any compliance above 0.01 mm/MPa.
#pragma once

#include <algorithm>
#include <vector>

namespace cpt::solver {

struct CompliantWall {
  double compliance = 0.0;  // [m/Pa] displacement over stress; 0 with a gap is a stiff wall behind the gap
  double gap = 0.0;         // [m]

  [[nodiscard]] bool on() const { return compliance != 0.0 || gap != 0.0; }
  /// Rise of the wall's stress [Pa] at an outward displacement [m]; not below zero.
  [[nodiscard]] double stress(double displacement) const {
    return std::max(0.0, displacement - gap) / std::max(compliance, 1e-11);
  }
};

/// Outward displacement of the soil at the wall, on levels that stay while the mesh moves.
class WallDisplacement {
 public:
  explicit WallDisplacement(double height);
  /// Adds dt times the radial velocity, linear between nodes at rising heights z [m] <= 0.
  void add(const std::vector<double>& z, const std::vector<double>& v_r, double dt);
  [[nodiscard]] double at(double z) const;  // [m]

  template <class Archive>
  void exchange(Archive& archive) {
    archive("wall.displacement", level_);
  }

 private:
  double spacing_;  // [m]
  std::vector<double> level_;
};

}  // namespace cpt::solver

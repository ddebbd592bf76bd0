#include "solver/mechanisms/compliant_wall.hpp"

#include <cmath>

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

WallDisplacement::WallDisplacement(double height) {
  const int levels = std::max(2, static_cast<int>(std::ceil(height / 0.01)) + 1);
  spacing_ = height / (levels - 1);
  level_.assign(static_cast<std::size_t>(levels), 0.0);
}

void WallDisplacement::add(const std::vector<double>& z, const std::vector<double>& v_r, double dt) {
  std::size_t k = 0;
  for (std::size_t i = level_.size(); i-- > 0;) {  // from the bottom upward, as z
    const double at = -spacing_ * static_cast<double>(i);
    while (k + 2 < z.size() && z[k + 1] < at) ++k;
    const double share = std::clamp((at - z[k]) / (z[k + 1] - z[k]), 0.0, 1.0);
    level_[i] += dt * (v_r[k] + share * (v_r[k + 1] - v_r[k]));
  }
}

double WallDisplacement::at(double z) const {
  const double level = std::clamp(-z / spacing_, 0.0, static_cast<double>(level_.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(level), level_.size() - 2);
  return level_[k] + (level - static_cast<double>(k)) * (level_[k + 1] - level_[k]);
}

Mechanism compliant_wall_mechanism() {
  return {
      .name = "compliant_wall",
      .title = "a chamber wall that gives way",
      .equation = "sigma_r = sigma'_h0 + max(0, u - gap) / compliance at the wall",
      .source = "Yost et al. (2023), section 3.1",
      .signature = "q_c is lower throughout, the more the deeper, towards that of the constant-stress wall.",
      .acts_on = any_soil,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::compliant_wall, &CompliantWall::compliance>(
                          "compliant_wall.compliance_mm_per_MPa", "c_wall", millimetres_per_megapascal, 0.0,
                          1.0e4, any_soil, "outward displacement of the wall over its stress",
                          "stiffness between a steel cylinder and a membrane"),
                      0.0, 60.0},
                     {number<&Setup::mechanisms, &Mechanisms::compliant_wall, &CompliantWall::gap>(
                          "compliant_wall.gap_mm", "g_wall", millimetres, 0.0, 10.0, any_soil,
                          "displacement of the wall at the initial stress before it resists",
                          "Yost et al. (2023), section 3.1"),
                      0.0, 0.3}}};
}

}  // namespace cpt::solver

#include "solver/mixed_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cpt::solver {
namespace {

struct Traction {
  double normal, shear;  // [Pa]
};

// On the interface at the end of the step if the soil took the cell's strain.
Traction trial_traction(const SoilInCell& soil, const InterfaceNormal& n, const CellStrainRate& rate,
                        double dt) {
  const PlaneGradient& L = rate.plane;
  const double lame = soil.modulus - 2.0 * soil.shear_modulus, two_G = 2.0 * soil.shear_modulus;
  const double volumetric = dt * lame * (L.rr + L.zz + rate.hoop);
  const double s_rr = soil.s_rr + volumetric + dt * two_G * L.rr,
               s_zz = soil.s_zz + volumetric + dt * two_G * L.zz;
  const double s_rz = soil.s_rz + dt * two_G * 0.5 * (L.rz + L.zr);
  return {n.r * n.r * s_rr + n.z * n.z * s_zz + 2.0 * n.r * n.z * s_rz,
          n.r * n.z * (s_zz - s_rr) + (n.r * n.r - n.z * n.z) * s_rz};
}

}  // namespace

bool share_motion(std::span<SoilInCell> soils, const InterfaceNormal& normal, const CellStrainRate& rate,
                  double dt) {
  std::array<Traction, most_materials> trial{};
  double t_n = 0.0, t_s = 0.0, compliance_n = 0.0, compliance_s = 0.0;
  for (std::size_t i = 0; i < soils.size(); ++i) {
    trial[i] = trial_traction(soils[i], normal, rate, dt);
    const double n = soils[i].share / soils[i].modulus, s = soils[i].share / soils[i].shear_modulus;
    t_n += n * trial[i].normal;
    t_s += s * trial[i].shear;
    compliance_n += n;
    compliance_s += s;
  }
  t_n /= compliance_n;
  t_s /= compliance_s;

  std::array<double, most_materials> a_n{}, a_s{};  // [-]
  double largest = 0.0;
  for (std::size_t i = 0; i < soils.size(); ++i) {
    a_n[i] = (t_n - trial[i].normal) / soils[i].modulus;
    a_s[i] = (t_s - trial[i].shear) / soils[i].shear_modulus;
    largest = std::max(largest, std::hypot(a_n[i], a_s[i]));
  }
  const bool limited = largest > largest_jump;
  const double scale = (limited ? largest_jump / largest : 1.0) / dt;
  for (std::size_t i = 0; i < soils.size(); ++i) {
    // Along the normal n and the tangent (-n_z, n_r).
    const double a_r = scale * (a_n[i] * normal.r - a_s[i] * normal.z);
    const double a_z = scale * (a_n[i] * normal.z + a_s[i] * normal.r);
    soils[i].jump = {a_r * normal.r, a_r * normal.z, a_z * normal.r, a_z * normal.z};
  }
  return limited;
}

}  // namespace cpt::solver

#include "solver/constitutive/norsand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/constitutive/critical_state_line.hpp"

namespace cpt::solver {
namespace {

// Widths of the rounded corner at triaxial compression in x = cos(1.5 theta + pi/4). The yield surface's only
// keeps its rounding error small; within the flow rule's (3.8 degrees of Lode angle) the direction of flow
// turns gradually.
constexpr double yield_corner = 1e-3;
constexpr double flow_corner = 0.1;
constexpr double near_axis = 0.1;

void set_binomial(double exponent, double (&coefficient)[8]) {
  coefficient[0] = 1.0;
  for (int k = 1; k < 8; ++k) coefficient[k] = coefficient[k - 1] * (exponent - (k - 1)) / k;
}

NorSandConstants derive(const NorSandParameters& sand, const GrainCrushing& crushing) {
  NorSandConstants c{};
  c.e_cs0 = sand.e_cs0;
  c.lambda = sand.lambda;
  c.m = sand.m;
  c.crushing = crushing.slope;
  c.log_p_crush = std::log(crushing.pressure);
  c.log_p_a = std::log(reference_pressure);
  c.G_scale = sand.G_ref * reference_pressure;
  // The elastic path in closed form has a removable singularity at b = 1.
  c.b = std::min(sand.b, 1.0 - 1e-6);
  set_binomial(c.b, c.power_b);
  set_binomial(c.m, c.power_m);
  // ((1 + (1-b) x)^(1/(1-b)) - 1) / x
  c.secant[0] = 1.0;
  for (int k = 1; k < 7; ++k) c.secant[k] = c.secant[k - 1] * (k * c.b - (k - 1)) / (k + 1);
  c.e_min_star = sand.e_min_star;
  c.K_over_G = 2.0 * (1.0 + sand.nu) / (3.0 * (1.0 - 2.0 * sand.nu));
  c.M_tc = 6.0 * std::sin(sand.phi_cs) / (3.0 - std::sin(sand.phi_cs));
  c.lode = c.M_tc / (3.0 + c.M_tc) / (std::sqrt(1.0 + yield_corner * yield_corner) - yield_corner);
  c.M_lowest = 1.0 - c.M_tc / (3.0 + c.M_tc);
  c.yield_corner = yield_corner;
  c.flow_corner = flow_corner;
  c.near_axis = near_axis;
  c.N = sand.N;
  c.chi_tc = sand.chi_tc;
  c.chi_over_M = sand.chi_tc / c.M_tc;
  c.H = sand.H;
  c.hardening_exponent = sand.hardening_exponent;
  c.log_cap = std::log(sand.cap_ratio);
  c.p_min = sand.p_min;
  c.p_i_min = sand.p_min / std::numbers::e;
  c.associated = sand.flow == DeviatoricFlow::associated ? 1.0 : 0.0;
  c.tolerance = sand.substep_tolerance;
  return c;
}

}  // namespace

NorSand::NorSand(const NorSandParameters& sand, const GrainCrushing& crushing)
    : constants_(derive(sand, crushing)), kernels_(&constitutive_kernels()), OCR_(sand.OCR) {}

double NorSand::initial_image_pressure(double s_rr, double s_zz, double s_tt, double s_rz, double e) const {
  // Fixed point of p_i = p exp(eta / M_i(p_i) - 1); M_i hardly depends on p_i, so that it settles in a few
  // rounds.
  double p_i = -(s_rr + s_zz + s_tt) / 3.0;
  for (int i = 0; i < 100; ++i) {
    const NorSandState s = evaluate({s_rr, s_zz, s_tt, s_rz}, e, p_i);
    const double next = s.p * std::exp(s.q / (s.p * s.M_i) - 1.0);
    const double change = std::abs(next - p_i);
    p_i = next;
    if (!(change > 1e-15 * p_i)) break;
  }
  return OCR_ * p_i;
}

}  // namespace cpt::solver

// NorSand in packs: yield surface, flow direction and hardening at a state.
//
// Departures from Jefferies & Been (2015), so that the law is defined everywhere: the corner of the Lode term
// at triaxial compression is rounded, and next to the axis q = 0 the direction of flow is that of the trial
// stress.
#pragma once

#include "solver/constitutive/norsand_state.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

/// M(theta) / M_tc = 1 - M_tc / (3 + M_tc) x with x = cos(1.5 theta + pi/4) = sqrt((1 - sin 3theta) / 2), but
/// for a tiny rounding that leaves triaxial compression and extension unchanged.
struct Lode {
  Pack sin3theta;
  Pack x;
  Pack ratio;  // M(theta) / M_tc
};
/// `unit` is the deviator divided by q.
CPT_INLINE Lode lode_at(const Constants& c, const Deviator& unit) {
  Lode lode;
  lode.sin3theta = at_most(at_least(13.5 * determinant(unit), splat(-1.0)), splat(1.0));
  lode.x = positive_sqrt(0.5 - 0.5 * lode.sin3theta + c.yield_corner * c.yield_corner);
  lode.ratio = 1.0 - c.lode * (lode.x - c.yield_corner);
  return lode;
}

/// F / p = eta - M_i (1 + ln(p_i / p)), for p >= p_min.
CPT_INLINE Pack yield_value(const Constants& c, Pack p, const Deviator& s, const Powers& w,
                            const Image& image) {
  const Pack q2 = at_least(1.5 * contract(s, s), splat(1e-20));
  const Pack inverse_q = inverse_sqrt(q2);
  const Lode lode = lode_at(c, inverse_q * s);
  return reciprocal(p * image.D) *
         (q2 * inverse_q * image.D - p * image.M_itc_D * lode.ratio * (1.0 + w.log_p_i - w.log_p));
}

constexpr double least_stiffness = 1e-2;  // [-] of the plastic stiffness over its elastic part

/// Everything a plastic increment needs at a state; n and m are gradients of F, in p and in the deviator.
struct Flow {
  Pack yield;      // [-] F / p
  Pack p;          // [Pa] with the floor p_min
  Pack eta;        // [-] q / p
  Pack M_i;        // [-]
  Pack G, K;       // [Pa]
  Pack n_p;        // [-] dF/dp = D_p
  Deviator n, m;   // [-] dF/ds and the deviatoric flow direction
  Deviator unit;   // [-] direction of flow, of length q = 1; zero on the vertex
  Pack hardening;  // [Pa] dp_i / dlambda
  Pack yield_e;    // [Pa] dF/de
  Pack stiffness;  // [Pa] n : D : m - dF/dp_i hardening
};
CPT_INLINE Flow select(Mask on, const Flow& a, const Flow& b) {
  return {select(on, a.yield, b.yield),
          select(on, a.p, b.p),
          select(on, a.eta, b.eta),
          select(on, a.M_i, b.M_i),
          select(on, a.G, b.G),
          select(on, a.K, b.K),
          select(on, a.n_p, b.n_p),
          select(on, a.n, b.n),
          select(on, a.m, b.m),
          select(on, a.unit, b.unit),
          select(on, a.hardening, b.hardening),
          select(on, a.yield_e, b.yield_e),
          select(on, a.stiffness, b.stiffness)};
}

/// (p / p_i)^x of the hardening rule
CPT_INLINE Pack hardening_power(const Constants& c, Pack p_over_p_i, const Powers& w) {
  if (c.hardening_exponent == 2.0) return p_over_p_i * p_over_p_i;
  return exp(c.hardening_exponent * (w.log_p - w.log_p_i));
}

/// Flow at y, where the powers are w, under a deviatoric strain increment. Near the axis q = 0 the equations
/// are stiff (the direction of s follows that of the strain within a strain of q / 3G): there, fading out up
/// to eta = near_axis, the direction is that of the elastic trial stress, as in an implicit return, and flow
/// is radial. Lanes of `on_vertex` flow volumetrically only.
[[maybe_unused]] static void flow_at(const Constants& c, const State& y, const Powers& w,
                                     const Deviator& strain, Mask on_vertex, Flow& f) {
  f.p = at_least(y.p, splat(c.p_min));
  const Image image = image_at(c, w, y.e);
  // One division for the reciprocals of p, p_i, e - e_min_star, D and D M_itc.
  const Pack gap = at_least(y.e - c.e_min_star, splat(smallest_gap));
  const Pack p_p_i = f.p * y.p_i, D_M = image.D * image.M_itc_D, gap_D_M = gap * D_M;
  const Pack inverse_all = reciprocal(p_p_i * gap_D_M);
  const Pack inverse_p_p_i = inverse_all * gap_D_M, inverse_D_M = inverse_all * p_p_i * gap;
  const Pack inverse_p = inverse_p_p_i * y.p_i, inverse_p_i = inverse_p_p_i * f.p;
  const Pack inverse_D = inverse_D_M * image.M_itc_D, inverse_M_itc = inverse_D_M * (image.D * image.D);
  const Pack chi = c.chi_tc * inverse_D, M_itc = image.M_itc_D * inverse_D;
  f.G = c.G_scale * w.power_p * (inverse_all * p_p_i * D_M);
  f.K = c.K_over_G * f.G;

  const Pack q2 = at_least(1.5 * contract(y.s, y.s), splat(1e-30));
  const Pack inverse_q = inverse_sqrt(q2), q = q2 * inverse_q;
  f.eta = q * inverse_p;
  const Pack away = at_most(f.eta * f.eta * (1.0 / (c.near_axis * c.near_axis)), splat(1.0));
  const Mask off_axis = greater(f.eta, splat(1e-14));
  Mask directed = off_axis & !on_vertex;
  f.unit = select(directed, inverse_q, splat(0.0)) * y.s;
  Lode lode = lode_at(c, f.unit);
  Pack M_ratio = select(directed, lode.ratio, splat(1.0));
  const Mask near = less(away, splat(1.0)) & !on_vertex;
  if (any(near)) {
    const Pack two_G = 2.0 * f.G, p2 = f.p * f.p;
    const Pack trial2 = two_G * two_G * (1.5 * contract(strain, strain));
    const Pack share = (1.0 - away) * trial2 / (q2 + trial2 + 1e-30 * p2);
    const Deviator trial = y.s + (share * two_G) * strain;
    const Pack length2 = 1.5 * contract(trial, trial);
    const Mask has_length = greater(length2, 1e-28 * p2);
    directed = (near & has_length) | (directed & !near);
    const Pack inverse = inverse_sqrt(select(has_length, length2, splat(1.0)));
    f.unit = select(near, select(has_length, inverse, splat(0.0)) * trial, f.unit);
    const Lode trial_lode = lode_at(c, f.unit);
    lode.x = select(near, trial_lode.x, lode.x);
    lode.sin3theta = select(near, trial_lode.sin3theta, lode.sin3theta);
    M_ratio = select(near & !off_axis & has_length, trial_lode.ratio, M_ratio);
  }
  f.M_i = M_itc * M_ratio;
  f.yield = f.eta - f.M_i * (1.0 + w.log_p_i - w.log_p);
  f.n_p = f.M_i - f.eta;

  // dF/ds = 3/2 unit - (q / g) dg/dsin3theta dsin3theta/ds, with p M_i (1 + ln(p_i/p)) = q on the surface.
  // In the flow rule a parabola takes the place of x next to the corner, so that its direction turns
  // gradually.
  const Pack parabola = (lode.x * lode.x) * (0.5 / c.flow_corner) + 0.5 * c.flow_corner;
  const Pack smooth_x = select(less(lode.x, splat(c.flow_corner)), parabola, lode.x);
  const Pack over_both = (0.25 * c.lode) * reciprocal(lode.x * smooth_x * M_ratio);
  const Pack hoop = f.unit.rr + f.unit.zz;
  const Pack shear2 = f.unit.rz * f.unit.rz;
  const Deviator square = {f.unit.rr * f.unit.rr + shear2 - 2.0 / 9.0,
                           f.unit.zz * f.unit.zz + shear2 - 2.0 / 9.0, hoop * f.unit.rz};
  const Deviator turn = over_both * (13.5 * square - 4.5 * lode.sin3theta * f.unit);
  f.n = select(directed, 1.5 * f.unit - smooth_x * turn, Deviator{});
  f.m = 1.5 * f.unit;
  if (c.associated != 0.0) f.m = select(directed, f.m - (away * lode.x) * turn, f.m);

  // Hardening: dp_i / de_q^p = p_i H (M_i / M_itc) (p / p_i)^x (p_mx / p - p_i / p), times de_q^p / dlambda.
  const Pack p_mx = exp(-chi * image.psi * inverse_M_itc);  // over p
  const Pack shear = positive_sqrt(select(directed, (2.0 / 3.0) * contract(f.m, f.m), splat(1.0)));
  const Pack relative = c.H * M_ratio * shear * hardening_power(c, f.p * inverse_p_i, w) *
                        (p_mx - y.p_i * inverse_p);  // dp_i / (p_i dlambda)
  f.hardening = relative * y.p_i;

  // F depends on p_i directly and through M_itc, and on e through M_itc.
  const Pack q_over_M = q * inverse_M_itc;
  const Pack signed_N = select(less(image.psi, splat(0.0)), splat(-c.N), splat(c.N));
  const Mask limited = at_most_mask(image.D, splat(smallest_chi_denominator));
  const Pack chi_growth = select(limited, splat(0.0), chi * chi * (c.m / c.M_tc) * w.slope);  // p_i dchi/dp_i
  const Pack M_itc_growth = -signed_N * (chi_growth * image.psi + chi * image.slope);  // p_i dM_itc/dp_i
  const Pack yield_growth = f.p * f.M_i + q_over_M * M_itc_growth;                     // -p_i dF/dp_i
  f.yield_e = q_over_M * (signed_N * chi);
  const Pack elastic = f.K * f.n_p * f.n_p + 2.0 * f.G * contract(f.n, f.m);
  f.stiffness = at_least(elastic + yield_growth * relative, least_stiffness * elastic);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

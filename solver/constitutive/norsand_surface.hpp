// NorSand in packs: moduli, yield surface, flow direction and hardening at a state.
//
// Compression is positive here. Equations: Jefferies & Been, Soil Liquefaction, 2nd ed. (2015), chapter 3 and
// appendix C. Departures: the Lode term's corner at triaxial compression is rounded, chi_i's denominator is
// limited, both so that the law is defined everywhere.
#pragma once

#include "solver/constitutive/norsand_constants.hpp"
#include "solver/constitutive/pack_math.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

using Constants = NorSandConstants;

/// Symmetric trace-free tensor; the hoop component is -(rr + zz).
struct Deviator {
  Pack rr, zz, rz;
};
CPT_INLINE Deviator operator+(const Deviator& a, const Deviator& b) {
  return {a.rr + b.rr, a.zz + b.zz, a.rz + b.rz};
}
CPT_INLINE Deviator operator-(const Deviator& a, const Deviator& b) {
  return {a.rr - b.rr, a.zz - b.zz, a.rz - b.rz};
}
CPT_INLINE Deviator operator*(Pack f, const Deviator& a) { return {f * a.rr, f * a.zz, f * a.rz}; }
CPT_INLINE Deviator operator*(double f, const Deviator& a) { return {f * a.rr, f * a.zz, f * a.rz}; }
CPT_INLINE Deviator select(Mask m, const Deviator& a, const Deviator& b) {
  return {select(m, a.rr, b.rr), select(m, a.zz, b.zz), select(m, a.rz, b.rz)};
}
/// a : b
CPT_INLINE Pack contract(const Deviator& a, const Deviator& b) {
  return a.rr * b.rr + a.zz * b.zz + (a.rr + a.zz) * (b.rr + b.zz) + 2.0 * (a.rz * b.rz);
}
/// det(a) = J3
CPT_INLINE Pack determinant(const Deviator& a) { return (a.rr + a.zz) * (a.rz * a.rz - a.rr * a.zz); }

struct State {
  Pack p;      // [Pa] mean stress
  Deviator s;  // [Pa] stress deviator
  Pack p_i;    // [Pa] image pressure
  Pack e;      // [-] void ratio
};
struct Strain {
  Pack v;      // [-] volumetric strain increment
  Deviator d;  // [-] deviatoric strain increment
};

/// What the image pressure and the void ratio decide.
struct Image {
  Pack log_p_i;   // [-] ln(p_i / 1 Pa)
  Pack slope;     // [-] m lambda (p_i / p_a)^m: local slope of the critical state line in ln p
  Pack psi;       // [-] e - e_c(p_i)
  Pack chi;       // [-] chi_tc / (1 - slope chi_tc / M_tc)
  Pack M_itc;     // [-] M_tc - N chi |psi|
  Pack log_p_mx;  // [-] ln(p_mx / p) = -chi psi / M_itc
};

/// Only psi and what follows from it depend on e: the rest is kept.
CPT_INLINE void set_void_ratio(const Constants& c, Pack e, Image& image) {
  image.psi = e - (c.e_cs0 - image.slope * (1.0 / c.m));
  const Pack product = image.chi * image.psi;
  image.M_itc = at_least(c.M_tc - c.N * abs(product), splat(0.1 * c.M_tc));
  image.log_p_mx = -product / image.M_itc;
}

CPT_INLINE Image image_at(const Constants& c, Pack p_i, Pack e) {
  Image image;
  image.log_p_i = log(p_i);
  image.slope = (c.m * c.lambda) * exp(c.m * (image.log_p_i - c.log_p_a));
  // The plain form is singular at high pressure (29 MPa for the baseline sand).
  image.chi = c.chi_tc / at_least(1.0 - c.chi_over_M * image.slope, splat(0.25));
  set_void_ratio(c, e, image);
  return image;
}

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
  lode.x = sqrt(0.5 - 0.5 * lode.sin3theta + c.yield_corner * c.yield_corner);
  lode.ratio = 1.0 - c.lode * (lode.x - c.yield_corner);
  return lode;
}

/// Shear modulus [Pa] at ln p and void ratio.
CPT_INLINE Pack shear_modulus(const Constants& c, Pack log_p, Pack e) {
  return c.G_scale * exp(c.b * (log_p - c.log_p_a)) / at_least(e - c.e_min_star, splat(0.01));
}

/// F / p = eta - M_i (1 + ln(p_i / p)), for p >= p_min.
CPT_INLINE Pack yield_value(const Constants& c, Pack p, Pack log_p, const Deviator& s, const Image& image) {
  const Pack q2 = 1.5 * contract(s, s);
  const Pack inverse_q = 1.0 / sqrt(at_least(q2, splat(1e-20)));
  const Lode lode = lode_at(c, inverse_q * s);
  return q2 * inverse_q / p - image.M_itc * lode.ratio * (1.0 + image.log_p_i - log_p);
}

/// Everything a plastic increment needs at a state; n and m are gradients of F, in p and in the deviator.
struct Flow {
  Pack p, log_p;  // [Pa] with the floor p_min
  Image image;
  Pack yield;      // [-] F / p
  Pack G, K;       // [Pa]
  Pack n_p;        // [-] dF/dp = D_p
  Deviator n, m;   // [-] dF/ds and the deviatoric flow direction
  Deviator unit;   // [-] s / q, or the direction of the strain deviator at the vertex
  Pack hardening;  // [Pa] dp_i / dlambda
  Pack yield_e;    // [Pa] dF/de
  Pack stiffness;  // [Pa] n : D : m - dF/dp_i hardening
};

/// At the isotropic vertex the direction of s is undefined: with `on_vertex` plastic flow is volumetric only,
/// elsewhere it follows the strain deviator.
[[maybe_unused]] static void flow_at(const Constants& c, const State& y, const Deviator& strain,
                                     Mask on_vertex, Flow& f) {
#ifdef CPT_COUNT
  ++cpt_count;
#endif
  f.p = at_least(y.p, splat(c.p_min));
  f.log_p = log(f.p);
  const Pack inverse_p = 1.0 / f.p;
  f.image = image_at(c, y.p_i, y.e);
  const Image& image = f.image;
  f.G = shear_modulus(c, f.log_p, y.e);
  f.K = c.K_over_G * f.G;

  const Pack q2 = 1.5 * contract(y.s, y.s);
  const Pack strain2 = 1.5 * contract(strain, strain);
  const Mask isotropic = at_most_mask(q2, 1e-18 * f.p * f.p);
  const Mask undirected = on_vertex | (isotropic & at_most_mask(strain2, splat(1e-28)));
  const Pack length2 = select(isotropic, strain2, q2);
  const Pack inverse = select(undirected, splat(0.0), 1.0 / sqrt(at_least(length2, splat(1e-30))));
  f.unit = inverse * select(isotropic, strain, y.s);
  const Pack q = select(isotropic, splat(0.0), q2 * inverse);
  Lode lode = lode_at(c, f.unit);
  lode.ratio = select(undirected, splat(1.0), lode.ratio);

  const Pack eta = q * inverse_p;
  const Pack M_i = image.M_itc * lode.ratio;
  f.yield = eta - M_i * (1.0 + image.log_p_i - f.log_p);
  f.n_p = M_i - eta;

  // dF/ds = 3/2 unit - (q / g) dg/dsin3theta dsin3theta/ds, with p M_i (1 + ln(p_i/p)) = q on the surface.
  // Next to the corner a parabola takes the place of x, so that the direction of flow turns gradually; near the axis,
  // where the Lode angle means little and the equations are stiff, flow becomes radial.
  const Pack parabola = (lode.x * lode.x) * (0.5 / c.flow_corner) + 0.5 * c.flow_corner;
  const Pack smooth_x = select(less(lode.x, splat(c.flow_corner)), parabola, lode.x);
  const Pack eta2 = eta * eta;
  const Pack a = 0.25 * c.lode * eta2 / (smooth_x * lode.ratio * (eta2 + c.radial_eta * c.radial_eta));
  const Pack hoop = f.unit.rr + f.unit.zz;
  const Pack shear2 = f.unit.rz * f.unit.rz;
  const Deviator square = {f.unit.rr * f.unit.rr + shear2 - 2.0 / 9.0,
                           f.unit.zz * f.unit.zz + shear2 - 2.0 / 9.0, hoop * f.unit.rz};
  const Deviator turn = a * (13.5 * square - 4.5 * lode.sin3theta * f.unit);
  f.n = select(undirected, Deviator{}, 1.5 * f.unit - turn);
  f.m = c.associated != 0.0 ? f.n : 1.5 * f.unit;

  // Hardening: dp_i / de_q^p = p_i H (M_i / M_itc) (p / p_i)^x (p_mx / p - p_i / p).
  const Pack ratio = y.p_i * inverse_p;
  const Pack power = exp(c.hardening_exponent * (f.log_p - image.log_p_i));
  const Pack shear =
      select(undirected, splat(1.0), sqrt((2.0 / 3.0) * contract(f.m, f.m)));  // de_q^p / dlambda
  f.hardening = c.H * y.p_i * lode.ratio * power * (exp(image.log_p_mx) - ratio) * shear;

  // F depends on p_i directly and through M_itc, and on e through M_itc.
  const Pack q_over_M = q / image.M_itc;
  const Pack inverse_p_i = 1.0 / y.p_i;
  const Pack sign = select(less(image.psi, splat(0.0)), splat(-1.0), splat(1.0));
  const Mask limited = at_most_mask(1.0 - c.chi_over_M * image.slope, splat(0.25));
  const Pack chi_growth =  // p_i dchi/dp_i
      select(limited, splat(0.0), image.chi * image.chi * (c.m / c.M_tc) * image.slope);
  const Pack M_itc_p_i = -c.N * (chi_growth * abs(image.psi) + image.chi * sign * image.slope) * inverse_p_i;
  const Pack yield_p_i = -f.p * M_i * inverse_p_i - q_over_M * M_itc_p_i;
  f.yield_e = q_over_M * c.N * image.chi * sign;
  const Pack elastic = f.K * f.n_p * f.n_p + 2.0 * f.G * contract(f.n, f.m);
  f.stiffness = at_least(elastic - yield_p_i * f.hardening, 1e-2 * elastic);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

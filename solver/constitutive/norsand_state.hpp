// NorSand in packs: the state of a point, and what pressure, image pressure and void ratio alone decide.
//
// Compression is positive here. Equations: Jefferies & Been, Soil Liquefaction, 2nd ed. (2015), chapter 3 and
// appendix C.
#pragma once

#include "solver/constitutive/norsand_constants.hpp"
#include "solver/constitutive/pack_math.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

using Constants = NorSandConstants;

constexpr double smallest_chi_denominator = 0.25;  // [-] of 1 - slope chi_tc / M_tc
constexpr double smallest_gap = 0.01;              // [-] of e - e_min_star
constexpr double least_M = 0.1;                    // [-] of M_itc / M_tc

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
CPT_INLINE State select(Mask m, const State& a, const State& b) {
  return {select(m, a.p, b.p), select(m, a.s, b.s), select(m, a.p_i, b.p_i), select(m, a.e, b.e)};
}

struct Strain {
  Pack v;      // [-] volumetric strain increment
  Deviator d;  // [-] deviatoric strain increment
};

/// The transcendental functions of p and p_i.
struct Powers {
  Pack log_p;    // [-] ln(p / 1 Pa)
  Pack power_p;  // [-] (p / p_a)^b
  Pack log_p_i;  // [-] ln(p_i / 1 Pa)
  Pack slope;    // [-] m lambda (p_i / p_a)^m: local slope of the critical state line in ln p
};

CPT_INLINE Powers powers_at(const Constants& c, Pack p, Pack p_i) {
  Powers w;
  w.log_p = log(p);
  w.power_p = exp(c.b * (w.log_p - c.log_p_a));
  w.log_p_i = log(p_i);
  w.slope = (c.m * c.lambda) * exp(c.m * (w.log_p_i - c.log_p_a));
  return w;
}

/// A state whose powers are known, to find those of its neighbours by series.
struct Base {
  Pack p, p_i, inverse_p, inverse_p_i;
  Powers powers;
};

constexpr double series_range =
    1.0 / 64.0;  // [-] change of a pressure up to which the series are exact to rounding

/// ln(1 + u)
CPT_INLINE Pack log_series(Pack u) {
  const Pack u2 = u * u, u4 = u2 * u2;
  return u + u2 * ((-1.0 / 2.0 + u * (1.0 / 3.0)) + u2 * (-1.0 / 4.0 + u * (1.0 / 5.0)) +
                   u4 * ((-1.0 / 6.0 + u * (1.0 / 7.0)) + u2 * (-1.0 / 8.0)));
}
/// (1 + u)^a from the binomial coefficients of a
CPT_INLINE Pack power_series(const double (&k)[8], Pack u) {
  const Pack u2 = u * u, u4 = u2 * u2;
  return ((k[0] + u * k[1]) + u2 * (k[2] + u * k[3])) + u4 * ((k[4] + u * k[5]) + u2 * (k[6] + u * k[7]));
}

CPT_INLINE Powers powers_near(const Constants& c, const Base& base, Pack p, Pack p_i) {
  const Pack u = (p - base.p) * base.inverse_p, u_i = (p_i - base.p_i) * base.inverse_p_i;
  Powers w = {base.powers.log_p + log_series(u), base.powers.power_p * power_series(c.power_b, u),
              base.powers.log_p_i + log_series(u_i), base.powers.slope * power_series(c.power_m, u_i)};
  const Mask near = at_most_mask(at_least(abs(u), abs(u_i)), splat(series_range));
  if (!all(near)) {
    const Powers far = powers_at(c, p, p_i);
    w = {select(near, w.log_p, far.log_p), select(near, w.power_p, far.power_p),
         select(near, w.log_p_i, far.log_p_i), select(near, w.slope, far.slope)};
  }
  return w;
}

/// What the image pressure and the void ratio decide, over the denominator D = 1 - slope chi_tc / M_tc of
/// chi_i = chi_tc / D so that nothing needs to be divided.
struct Image {
  Pack psi;      // [-] e - e_c(p_i)
  Pack slope;    // [-] dpsi / d ln p_i: that of the critical state line, with crushing
  Pack D;        // [-] limited: the plain form is singular at high pressure (29 MPa for the baseline sand)
  Pack M_itc_D;  // [-] D M_itc = D M_tc - N chi_tc |psi|, limited to 0.1 D M_tc
};
CPT_INLINE Image image_at(const Constants& c, const Powers& w, Pack e) {
  Image image;
  const Pack beyond = at_least(w.log_p_i - c.log_p_crush, splat(0.0));
  image.psi = e - c.e_cs0 + w.slope * (1.0 / c.m) + c.crushing * beyond;
  image.slope = w.slope + select(greater(beyond, splat(0.0)), splat(c.crushing), splat(0.0));
  const Pack slope = image.slope;
  image.D = at_least(1.0 - c.chi_over_M * slope, splat(smallest_chi_denominator));
  const Pack M_tc_D = c.M_tc * image.D;
  image.M_itc_D = at_least(M_tc_D - (c.N * c.chi_tc) * abs(image.psi), least_M * M_tc_D);
  return image;
}

/// Positive where p_i exceeds cap_ratio p_mx: ln(p_i / (cap_ratio p_mx)) D M_itc.
CPT_INLINE Pack excess_over_cap(const Constants& c, const Powers& w, const Image& image) {
  return (w.log_p_i - w.log_p - c.log_cap) * image.M_itc_D + c.chi_tc * image.psi;
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

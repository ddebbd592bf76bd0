// The stress updates of Tresca and of linear elasticity for a batch.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"
#include "solver/constitutive/pack_math.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

struct Trial {
  Pack rr, zz, tt, rz;
};

/// Hooke's law; the void ratio follows the volumetric strain.
CPT_INLINE Trial elastic_trial(const ElasticConstants& c, const Batch& b, decltype(b.size) k) {
  const Pack d_rr = load(b.d_rr + k), d_zz = load(b.d_zz + k), d_tt = load(b.d_tt + k);
  const Pack volume = d_rr + d_zz + d_tt;
  const Pack pressure = c.lame * volume;
  const Pack e = load(b.e + k);
  store(b.e + k, e + (1.0 + e) * (volume * (1.0 + volume * (0.5 + volume * (1.0 / 6.0)))));
  return {load(b.s_rr + k) + (pressure + c.two_G * d_rr), load(b.s_zz + k) + (pressure + c.two_G * d_zz),
          load(b.s_tt + k) + (pressure + c.two_G * d_tt), load(b.s_rz + k) + c.two_G * load(b.d_rz + k)};
}

CPT_INLINE void store_stress(const Batch& b, decltype(b.size) k, const Trial& t) {
  store(b.s_rr + k, t.rr);
  store(b.s_zz + k, t.zz);
  store(b.s_tt + k, t.tt);
  store(b.s_rz + k, t.rz);
}

[[maybe_unused]] static void update_linear_elastic(const ElasticConstants& c, const Batch& batch) {
  for (decltype(batch.size) k = 0; k < batch.size; k += lanes)
    store_stress(batch, k, elastic_trial(c, batch, k));
}

/// Exact return to the hexagon: the middle principal deviator keeps its value within -+ 2 s_u / 3 (its value
/// at the corners), the outer two lie s_u to either side of minus half of it. The pressure and the principal
/// directions stay. No order of the principal stresses is assumed but a >= b in the plane. `excess` is how
/// far sigma_1 - sigma_3 of the trial exceeds 2 s_u [Pa].
CPT_INLINE Trial return_to_tresca(Pack s_u, const Trial& s, Pack& excess) {
  const Pack centre = 0.5 * (s.rr + s.zz), half = 0.5 * (s.rr - s.zz);
  const Pack radius2 = at_least(half * half + s.rz * s.rz, splat(1e-200));
  const Pack inverse_radius = inverse_sqrt(radius2), radius = radius2 * inverse_radius;
  const Pack a = centre + radius, b = centre - radius, t = s.tt;
  const Mask hoop_largest = less(a, t), hoop_smallest = less(t, b);
  const Pack largest_stress = at_least(a, t), smallest_stress = at_most(b, t);
  const Pack mean = (2.0 * centre + t) * (1.0 / 3.0);
  const Pack middle_trial = select(hoop_largest, a, select(hoop_smallest, b, t)) - mean;
  const Pack corner = 2.0 * s_u / 3.0;
  const Pack middle = at_most(at_least(middle_trial, -corner), corner);
  const Pack major = mean + (s_u - 0.5 * middle), minor = mean - (s_u + 0.5 * middle), medium = mean + middle;

  const Pack a_new = select(hoop_largest, medium, major);
  const Pack b_new = select(hoop_smallest, medium, minor);
  const Pack t_new = select(hoop_largest, major, select(hoop_smallest, minor, medium));
  const Pack centre_new = 0.5 * (a_new + b_new);
  const Pack shrink = 0.5 * (a_new - b_new) * inverse_radius;
  excess = largest_stress - smallest_stress - 2.0 * s_u;
  const Mask outside = greater(largest_stress - smallest_stress, 2.0 * s_u);
  return {select(outside, centre_new + shrink * half, s.rr),
          select(outside, centre_new - shrink * half, s.zz), select(outside, t_new, s.tt),
          select(outside, shrink * s.rz, s.rz)};
}

[[maybe_unused]] static void update_tresca(const TrescaConstants& c, const Batch& batch) {
  for (decltype(batch.size) k = 0; k < batch.size; k += lanes) {
    Pack excess;
    store_stress(batch, k, return_to_tresca(splat(c.s_u), elastic_trial(c.elastic, batch, k), excess));
  }
}

/// Largest less smallest principal value of the strain increment [-].
CPT_INLINE Pack shear_increment(const Batch& b, decltype(b.size) k) {
  const Pack rr = load(b.d_rr + k), zz = load(b.d_zz + k), tt = load(b.d_tt + k), rz = load(b.d_rz + k);
  const Pack half = 0.5 * (rr - zz), centre = 0.5 * (rr + zz);
  const Pack radius = positive_sqrt(at_least(half * half + rz * rz, splat(1e-200)));
  return at_least(centre + radius, tt) - at_most(centre - radius, tt);
}

/// h_0 is s_u0, h_1 the plastic shear strain xi.
/// s_u = s_u0 (1 - loss (1 - exp(-3 xi / xi_95))) (1 + mu log10(max(rate, reference) / reference)): Einav &
/// Randolph, Int. J. Numer. Meth. Engng 63 (2005) 991-1003, with s_u0 the point's own. The plastic shear
/// strain of a step is the part of sigma_1 - sigma_3 that the return takes away, over 2 G.
[[maybe_unused]] static void update_varying_tresca(const VaryingTrescaConstants& c, const Batch& batch) {
  const double to_rate = batch.dt > 0.0 ? c.inverse_reference_rate / batch.dt : 0.0;
  for (decltype(batch.size) k = 0; k < batch.size; k += lanes) {
    const Pack xi = load(batch.h_1 + k);
    const Pack remoulded = c.loss * (1.0 - exp((-3.0 * c.inverse_xi_95) * xi));
    const Pack rate = at_least(to_rate * shear_increment(batch, k), splat(1.0));
    const Pack faster = 1.0 + (c.mu * 0.43429448190325182) * log(rate);
    const Pack s_u = load(batch.h_0 + k) * (1.0 - remoulded) * faster;
    Pack excess;
    store_stress(batch, k, return_to_tresca(s_u, elastic_trial(c.elastic, batch, k), excess));
    store(batch.h_1 + k, xi + at_least(excess, splat(0.0)) * (1.0 / c.elastic.two_G));
  }
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

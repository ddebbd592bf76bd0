// The stress update of NorSand for a batch.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/norsand_substeps.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double cap_tolerance = 1e-9;  // [-] of excess_over_cap
constexpr int cap_limit = 5;

/// Inner cap: lowers p_i to cap_ratio p_mx, then brings the stress back inside the yield surface. `w` are the
/// powers at y, and become those of the result.
[[maybe_unused]] static void apply_cap(const Constants& c, const Base& base, State& y, Powers& w) {
  Mask capped = none();
  for (int i = 0; i < cap_limit; ++i) {
    // Newton's method for ln p_i, because p_mx itself depends on p_i through psi_i.
    const Image image = image_at(c, w, y.e);
    const Pack excess = excess_over_cap(c, w, image);
    const Mask above = greater(excess, splat(cap_tolerance));
    if (!any(above)) break;
    const Pack log_p_i = w.log_p_i - excess / (image.M_itc_D + c.chi_tc * image.slope);
    y.p_i = select(above, at_least(exp(log_p_i), splat(c.p_i_min)), y.p_i);
    w = powers_of(c, base, y);
    capped = capped | above;
  }
  capped = capped & !less(y.p, splat(c.p_min));
  if (!any(capped)) return;
  Flow f;
  flow_at(c, y, w, Deviator{}, none(), f);
  const Mask outside = capped & greater(f.yield, splat(yield_tolerance));
  if (any(outside)) correct_drift(c, base, y, f, outside, none(), true);
  w = powers_of(c, base, y);
}

/// Stress as a batch holds it, tension-positive.
struct Stress {
  Pack rr, zz, tt, rz;
};

/// Elastic restart of lanes below p_min: the part of the increment that brings p back to p_min is used up.
[[maybe_unused]] static void recompress(const Constants& c, Mask loose, State& y, Strain& strain,
                                        Stress& stress) {
  const Pack G = c.G_scale * exp(c.b * (log(splat(c.p_min)) - c.log_p_a)) /
                 at_least(y.e - c.e_min_star, splat(smallest_gap));
  const Pack K = c.K_over_G * G;
  const Pack growth = K * strain.v;
  const Pack missing = c.p_min - y.p;
  const Mask restored = greater(growth, missing);
  const Pack used = select(restored, missing / select(restored, growth, splat(1.0)), splat(1.0));
  const Pack p = select(restored, splat(c.p_min), at_least(y.p + growth, splat(0.0)));
  y.p = select(loose, p, y.p);
  y.s = select(loose, Deviator{}, y.s);
  const Pack rest = select(loose, 1.0 - used, splat(1.0));
  strain = {rest * strain.v, rest * strain.d};
  stress = {select(loose, -p, stress.rr), select(loose, -p, stress.zz), select(loose, -p, stress.tt),
            select(loose, splat(0.0), stress.rz)};
}

/// The whole update of the lanes that the elastic path alone does not settle; others keep `y`, the elastic
/// trial. `w` are the powers at y.
[[maybe_unused]] static void update_slowly(const Constants& c, const ElasticPath& path, Pack F, Mask slow,
                                           Mask contracting, Pack e_end, State& y, Powers& w) {
  const State trial = y;
  const Mask plastic = slow & greater(F, splat(yield_tolerance));
  if (any(plastic)) integrate_plastic(c, path, F, plastic, y);
  y.e = e_end;
  w = powers_of(c, path.base, y);
  const Mask capped = slow & greater(excess_over_cap(c, w, image_at(c, w, y.e)), splat(cap_tolerance));
  if (any(capped)) apply_cap(c, path.base, y, w);

  // No stress below p_min, but p grows from zero in recompression.
  const Mask weak = less(y.p, splat(c.p_min));
  const Mask stays = greater(y.p, splat(0.0)) & contracting;
  y.p = select(weak & !stays, splat(0.0), y.p);
  y.s = select(weak, Deviator{}, y.s);
  y = select(slow, y, trial);
}

/// Updates the pack at `k`; returns its P-wave moduli [Pa].
CPT_INLINE Pack update_pack(const Constants& c, const Batch& batch, decltype(batch.size) k) {
  Stress stress = {load(batch.s_rr + k), load(batch.s_zz + k), load(batch.s_tt + k), load(batch.s_rz + k)};
  const Pack e = load(batch.e + k), p_i = load(batch.h_0 + k);
  const Pack d_rr = load(batch.d_rr + k), d_zz = load(batch.d_zz + k), d_tt = load(batch.d_tt + k);
  const Pack d_rz = load(batch.d_rz + k);
  // Zero, or NaN for a lane with anything non-finite: added to the results.
  const Pack poison = 0.0 * (((stress.rr + stress.zz) + (stress.tt + stress.rz)) +
                             ((d_rr + d_zz) + (d_tt + d_rz)) + (e + p_i));

  Strain strain;
  strain.v = -(d_rr + d_zz + d_tt);
  const Pack third = strain.v * (1.0 / 3.0);
  strain.d = {-d_rr - third, -d_zz - third, -d_rz};
  const Mask contracting = greater(strain.v, splat(0.0));
  const Pack v = strain.v;
  const Pack e_growth = (1.0 + e) * (v * (-1.0 + v * (1.0 / 2.0 - v * (1.0 / 6.0 - v * (1.0 / 24.0)))));
  const Pack e_end = e + e_growth;  // (1 + e) exp(-v) - 1

  State y;
  y.p = (stress.rr + stress.zz + stress.tt) * (-1.0 / 3.0);
  y.s = {-stress.rr - y.p, -stress.zz - y.p, -stress.rz};
  y.p_i = at_least(p_i, splat(c.p_i_min));
  y.e = e;
  const Mask loose = less(y.p, splat(c.p_min));
  if (any(loose)) recompress(c, loose, y, strain, stress);

  ElasticPath path;
  path.base.p = at_least(y.p, splat(c.p_min));
  path.base.p_i = y.p_i;
  path.base.powers = powers_at(c, path.base.p, y.p_i);
  // One division for the reciprocals of p, p_i and e - e_min_star midway and at the end.
  const Pack gap = at_least(e + 0.5 * e_growth - c.e_min_star, splat(smallest_gap));
  const Pack gap_end = at_least(e_end - c.e_min_star, splat(smallest_gap));
  const Pack p_p_i = path.base.p * y.p_i, gaps = gap * gap_end;
  const Pack inverse_all = reciprocal(p_p_i * gaps);
  path.base.inverse_p = inverse_all * gaps * y.p_i;
  path.base.inverse_p_i = inverse_all * gaps * path.base.p;
  const Pack stiffness_end = c.G_scale * (inverse_all * p_p_i * gap);

  path.start = y;
  path.strain = strain;
  path.e_growth = e_growth;
  const Pack G = c.G_scale * path.base.powers.power_p * (inverse_all * p_p_i * gap_end);
  path.two_G = 2.0 * G;
  path.K = c.K_over_G * G;
  path.x = path.K * strain.v * path.base.inverse_p;
  const Pack factor = secant_factor(c, path.x);
  const Pack dp = factor * (path.K * strain.v);
  const Deviator ds = (factor * path.two_G) * strain.d;
  State end = {y.p + dp, y.s + ds, y.p_i, e_end};
  stress = {stress.rr - (dp + ds.rr), stress.zz - (dp + ds.zz), stress.tt - (dp - ds.rr - ds.zz),
            stress.rz - ds.rz};

  // Surely elastic: inside the circle through the yield surface's least M, with nothing else to do.
  Powers w = powers_of(c, path.base, end);
  const Image image = image_at(c, w, e_end);
  const Pack p = at_least(end.p, splat(c.p_min));
  const Pack q_D_limit = (c.M_lowest * (1.0 + w.log_p_i - w.log_p)) * (p * image.M_itc_D);
  const Mask inside = less(1.5 * contract(end.s, end.s) * (image.D * image.D), q_D_limit * q_D_limit) &
                      greater(q_D_limit, splat(0.0));
  Mask slow =
      loose | less(end.p, splat(c.p_min)) | greater(excess_over_cap(c, w, image), splat(cap_tolerance));
  if (any(slow | !inside)) {
    const Pack F = yield_value(c, p, end.s, w, image);
    slow = slow | greater(F, splat(yield_tolerance));
    if (any(slow)) {
      update_slowly(c, path, F, slow, contracting, e_end, end, w);
      stress = {select(slow, -(end.p + end.s.rr), stress.rr), select(slow, -(end.p + end.s.zz), stress.zz),
                select(slow, end.s.rr + end.s.zz - end.p, stress.tt), select(slow, -end.s.rz, stress.rz)};
    }
  }

  store(batch.s_rr + k, stress.rr + poison);
  store(batch.s_zz + k, stress.zz + poison);
  store(batch.s_tt + k, stress.tt + poison);
  store(batch.s_rz + k, stress.rz + poison);
  store(batch.e + k, e_end + poison);
  store(batch.h_0 + k, end.p_i + poison);
  return (c.K_over_G + 4.0 / 3.0) * (stiffness_end * w.power_p);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

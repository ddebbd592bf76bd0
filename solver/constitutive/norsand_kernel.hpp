// The stress update of NorSand for a batch.
//
// Elastic steps use the closed form of the hypoelastic law; plastic ones start where the elastic path meets
// the yield surface (Pegasus) and go on by modified Euler sub-steps with error control and drift correction:
// Sloan, Abbo & Sheng, Engineering Computations 18 (2001) 121-154.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/norsand_surface.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double yield_tolerance = 1e-8;  // [-] |F| / p that counts as on the surface
constexpr double smallest_substep =
    1e-4;                             // [-] fraction of the increment that is accepted whatever its error
constexpr double vertex_size = 1e-4;  // [-] q / p up to which a state counts as on the axis
constexpr double small_deviator =
    1e-4;                             // [-] s : s / p^2 below which errors of s are no longer relative to it
constexpr double smallest_approach = 1e-6;    // [-] the same on the way to the vertex
constexpr int substep_limit = 400;  // [-] more than the smallest sub-step can need
constexpr int crossing_limit = 30;
constexpr int drift_limit = 8;
constexpr double cap_tolerance = 1e-9;  // [-] ln(p_i / (cap_ratio p_mx)) that counts as at the cap
constexpr int cap_limit = 5;

/// p along the elastic path over the growth that the initial modulus gives: ((1 + (1-b) x)^(1/(1-b)) - 1) / x
/// with x = K dv / p. The deviator follows in proportion, because G / K is constant.
CPT_INLINE Pack secant_factor(const Constants& c, Pack x) {
  const double c2 = c.b / 2.0, c3 = c2 * (2.0 * c.b - 1.0) / 3.0, c4 = c3 * (3.0 * c.b - 2.0) / 4.0;
  const double c5 = c4 * (4.0 * c.b - 3.0) / 5.0, c6 = c5 * (5.0 * c.b - 4.0) / 6.0;
  const Pack series = 1.0 + x * (c2 + x * (c3 + x * (c4 + x * (c5 + x * c6))));
  const Mask small = at_most_mask(abs(x), splat(0.01));
  if (all(small)) return series;
  const double power = 1.0 - c.b;
  const Pack base = at_least(1.0 + power * x, splat(1e-30));
  const Pack exact = (exp(log(base) * (1.0 / power)) - 1.0) / select(small, splat(1.0), x);
  return select(small, series, exact);
}

/// The elastic path of an increment, from its start to a fraction t of it.
struct ElasticPath {
  State start;
  Strain strain;
  Pack K;         // [Pa] bulk modulus at the start
  Pack two_G;     // [Pa] twice the shear modulus
  Pack e_growth;  // [-]
  Pack x;         // [-] K dv / p

  __attribute__((always_inline)) State at(const Constants& c, Pack t) const {
    const Pack factor = t * secant_factor(c, t * x);
    return {start.p + factor * (K * strain.v), start.s + (factor * two_G) * strain.d, start.p_i,
            start.e + t * e_growth};
  }
};

struct Increment {
  Pack p;
  Deviator s;
  Pack p_i;
};
/// Elastic-plastic increment for a fraction h of the strain.
CPT_INLINE Increment increment_at(const Flow& f, const Strain& strain, Pack e_growth, Pack h) {
  const Pack two_G = 2.0 * f.G;
  const Pack load = f.K * f.n_p * strain.v + two_G * contract(f.n, strain.d) + f.yield_e * e_growth;
  const Pack multiplier = h * at_least(load / f.stiffness, splat(0.0));
  return {f.K * (h * strain.v - multiplier * f.n_p), two_G * (h * strain.d - multiplier * f.m),
          multiplier * f.hardening};
}
CPT_INLINE State step(const Constants& c, const State& y, const Increment& d, Pack e_growth, Pack h) {
  return {y.p + d.p, y.s + d.s, at_least(y.p_i + d.p_i, splat(c.p_i_min)), y.e + h * e_growth};
}
CPT_INLINE State select(Mask m, const State& a, const State& b) {
  return {select(m, a.p, b.p), select(m, a.s, b.s), select(m, a.p_i, b.p_i), select(m, a.e, b.e)};
}

/// One modified Euler step from y over a fraction h. error2 is the square of its relative error. `turn` is
/// the fraction of the step, linearly, at which the deviator turns round; 1 where it does not.
[[maybe_unused]] static State modified_euler(const Constants& c, const State& y, const Flow& f,
                                             const Strain& strain, Pack e_growth, Pack h, Mask on_vertex,
                                             Pack& error2, Pack& turn) {
  const Increment d1 = increment_at(f, strain, e_growth, h);
  const State middle = step(c, y, d1, e_growth, h);
  Flow f1;
  flow_at(c, middle, strain.d, on_vertex, f1);
  const Increment d2 = increment_at(f1, strain, e_growth, h);
  const Increment mean = {0.5 * (d1.p + d2.p), 0.5 * (d1.s + d2.s), 0.5 * (d1.p_i + d2.p_i)};
  const State end = step(c, y, mean, e_growth, h);
  const Pack dp = 0.5 * (d2.p - d1.p);
  const Deviator ds = 0.5 * (d2.s - d1.s);
  const Pack dp_i = 0.5 * (d2.p_i - d1.p_i) / end.p_i;
  const Pack p = at_least(end.p, splat(c.p_min));
  const Pack p2 = p * p;
  error2 = dp * dp / p2 + contract(ds, ds) / (contract(end.s, end.s) + small_deviator * p2) + dp_i * dp_i;
  const Pack q = contract(y.s, f.unit);
  const Pack q_end = at_most(contract(middle.s, f.unit), contract(end.s, f.unit));
  turn = select(less(q_end, splat(0.0)), at_least(q, splat(0.0)) / (q - q_end), splat(1.0));
  return end;
}

/// The isotropic vertex (q = 0, p = e p_i). A lane near it stays there if, starting on the axis in the
/// direction of the strain deviator, it is driven back: then plastic flow is volumetric and keeps q = 0.
/// Replaces the step of lanes that stay or that went beyond the axis; returns those that stay.
[[maybe_unused]] static Mask step_near_axis(const Constants& c, const State& now, const Strain& strain,
                                            Pack e_growth, Pack h, Mask near, Mask beyond, State& next,
                                            Pack& error2) {
  const State axis = {now.p, Deviator{}, now.p_i, now.e};
  Flow f;
  flow_at(c, axis, strain.d, none(), f);
  Pack axis_error2, turn;
  State end = modified_euler(c, axis, f, strain, e_growth, h, none(), axis_error2, turn);
  const Mask stays = near & less(turn, splat(1.0));
  next = select(near & beyond, end, next);
  error2 = select(near & beyond, axis_error2, error2);
  if (!any(stays)) return stays;
  flow_at(c, axis, strain.d, stays, f);
  end = modified_euler(c, axis, f, {strain.v, Deviator{}}, e_growth, h, stays, axis_error2, turn);
  next = select(stays, end, next);
  error2 = select(stays, axis_error2, error2);
  return stays;
}

/// Brings lanes back to the yield surface at constant strain.
[[maybe_unused]] static void correct_drift(const Constants& c, State& y, const Strain& strain, Mask lanes_on,
                                           Mask on_vertex, bool only_outside) {
  Mask open = lanes_on;
  for (int i = 0; i < drift_limit; ++i) {
    Flow f;
    flow_at(c, y, strain.d, on_vertex, f);
    const Pack distance = only_outside ? f.yield : abs(f.yield);
    const Mask off = open & greater(distance, splat(yield_tolerance));
    if (!any(off)) return;
    const Pack multiplier = select(off, f.yield * f.p / f.stiffness, splat(0.0));
    y.p -= multiplier * f.K * f.n_p;
    y.s = y.s - (2.0 * f.G * multiplier) * f.m;
    y.p_i = at_least(y.p_i + multiplier * f.hardening, splat(c.p_i_min));
    // The correction's own error is of the order of the distance squared, over eta near the axis.
    const Pack eta = f.image.M_itc - f.n_p;
    open = off & greater(distance, 1e-5 * eta);
    if (!any(open)) return;
  }
}

/// Fraction of the increment at which the elastic path leaves the yield surface for the last time.
[[maybe_unused]] static Pack crossing(const Constants& c, const ElasticPath& path, const Image& start_image,
                                      Pack F_0, Pack F_1, Mask inside, Mask reversing) {
  const auto yield_at = [&](Pack t) __attribute__((always_inline)) {
    const State y = path.at(c, t);
    const Pack p = at_least(y.p, splat(c.p_min));
    Image image = start_image;
    set_void_ratio(c, y.e, image);
    return yield_value(c, p, log(p), y.s, image);
  };
  // A path that first runs inside: look for a point there.
  Pack low = splat(0.0), F_low = F_0;
  Mask search = reversing;
  for (double t = 0.5; t > 1e-3 && any(search); t *= 0.5) {
    const Pack F = yield_at(splat(t));
    const Mask found = search & less(F, splat(-yield_tolerance));
    low = select(found, splat(t), low);
    F_low = select(found, F, F_low);
    inside = inside | found;
    search = search & !found;
  }
  Pack high = splat(1.0), F_high = F_1, result = splat(0.0);
  Mask open = inside;
  for (int i = 0; i < crossing_limit && any(open); ++i) {
    const Pack t = high - F_high * (high - low) / (F_high - F_low);
    const Pack F = yield_at(t);
    result = select(open, t, result);
    const Mask opposite = less(F * F_high, splat(0.0));
    low = select(opposite, high, low);
    F_low = select(opposite, F_high, F_low * (F_high / (F_high + F)));
    high = t;
    F_high = F;
    open = open & greater(abs(F), splat(yield_tolerance));
  }
  return at_most(at_least(result, splat(0.0)), splat(1.0));
}

/// Carries the lanes of `plastic` from the start of the path to its end through yield; others keep `y`.
[[maybe_unused]] static void integrate_plastic(const Constants& c, const ElasticPath& path, Pack F_1,
                                               Mask plastic, State& y) {
  Strain strain = path.strain;
  Pack e_growth = path.e_growth;
  State now = path.start;
  Flow f;
  flow_at(c, now, strain.d, none(), f);
  const Mask inside = plastic & less(f.yield, splat(-yield_tolerance));
  const Pack elastic_load = f.K * f.n_p * strain.v + 2.0 * f.G * contract(f.n, strain.d);
  const Mask reversing = plastic & !inside & less(elastic_load, splat(0.0));
  if (any(inside | reversing)) {
    const Pack t = crossing(c, path, f.image, f.yield, F_1, inside, reversing);
    now = select(greater(t, splat(0.0)), path.at(c, t), now);
    strain = {(1.0 - t) * strain.v, (1.0 - t) * strain.d};
    e_growth = (1.0 - t) * e_growth;
    flow_at(c, now, strain.d, none(), f);
  }

  const Pack tolerance2 = splat(c.tolerance * c.tolerance);
  Pack done = splat(0.0), length = splat(1.0);
  Mask active = plastic;
  for (int i = 0; i < substep_limit; ++i) {
    const Pack rest = 1.0 - done;
    const Pack h = at_most(length, rest);
    Pack error2, turn;
    State next = modified_euler(c, now, f, strain, e_growth, h, none(), error2, turn);
    // A step beyond the axis is shortened until it ends near it; there the vertex takes over.
    const Mask beyond = less(turn, splat(1.0));
    const Mask shortest = at_most_mask(h, splat(smallest_substep));
    const Mask near =
        active & (at_most_mask(1.5 * contract(now.s, f.unit), vertex_size * f.p) | at_most_mask(h, splat(smallest_approach)));
    const Mask too_far = beyond & !near;
    Mask on_vertex = none();
    if (any(near)) on_vertex = step_near_axis(c, now, strain, e_growth, h, near, beyond, next, error2);
    const Mask defined = at_most_mask(error2, splat(1e300));
    const Mask accepted = active & !too_far & (at_most_mask(error2, tolerance2) | shortest | !defined);
    if (any(accepted)) {
      correct_drift(c, next, strain, accepted, on_vertex, false);
      now = select(accepted, next, now);
      done = select(accepted, done + h, done);
    }
    const Mask ended = accepted & (less(now.p, splat(c.p_min)) | at_most_mask(rest, h) | !defined);
    active = active & !ended;
    if (!any(active)) break;
    const Pack factor = 0.9 * sqrt(sqrt(tolerance2 / at_least(error2, splat(1e-40))));
    const Pack change = select(too_far, 0.999 * turn, at_most(at_least(factor, splat(0.1)), splat(2.0)));
    length = at_least(h * change, select(too_far, splat(0.0), splat(smallest_substep)));
    flow_at(c, now, strain.d, none(), f);
  }
  y = select(plastic, now, y);
}

/// ln(p_i / (cap_ratio p_mx))
CPT_INLINE Pack excess_over_cap(const Constants& c, const Image& image, Pack log_p) {
  return image.log_p_i - log_p - (c.log_cap + image.log_p_mx);
}

/// The rules at the ends of the law's range: inner cap, and no stress below p_min.
CPT_INLINE void limit_state(const Constants& c, const Strain& strain, Mask contracting, State& y) {
  const Pack log_p = log(at_least(y.p, splat(c.p_min)));
  Mask capped = none();
  for (int i = 0; i < cap_limit; ++i) {
    // Newton's method for ln p_i, because p_mx itself depends on p_i through psi_i.
    const Image image = image_at(c, y.p_i, y.e);
    const Pack excess = excess_over_cap(c, image, log_p);
    const Mask above = greater(excess, splat(cap_tolerance));
    if (!any(above)) break;
    const Pack log_p_i = image.log_p_i - excess / (1.0 + image.chi * image.slope / image.M_itc);
    y.p_i = select(above, at_least(exp(log_p_i), splat(c.p_i_min)), y.p_i);
    capped = capped | above;
  }
  const Mask carries = !less(y.p, splat(c.p_min));
  if (any(capped)) correct_drift(c, y, strain, capped & carries, none(), true);
  const Mask stays = greater(y.p, splat(0.0)) & contracting;
  const Mask weak = less(y.p, splat(c.p_min));
  y.p = select(weak & !stays, splat(0.0), y.p);
  y.s = select(weak, Deviator{}, y.s);
}

/// Stress as a batch holds it, tension-positive.
struct Stress {
  Pack rr, zz, tt, rz;
};

/// Elastic restart of lanes below p_min: the part of the increment that brings p back to p_min is used up.
[[maybe_unused]] static void recompress(const Constants& c, Mask loose, State& y, Strain& strain,
                                        Stress& stress) {
  const Pack K = c.K_over_G * shear_modulus(c, log(splat(c.p_min)), y.e);
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

/// The whole update of one pack that the elastic path alone does not settle.
[[maybe_unused]] static void update_slowly(const Constants& c, const ElasticPath& path, const State& trial,
                                           Pack F, Mask slow, Mask contracting, Pack e_end, State& y,
                                           Stress& stress) {
  y = trial;
  const Mask plastic = slow & greater(F, splat(yield_tolerance));
  if (any(plastic)) integrate_plastic(c, path, F, plastic, y);
  y.e = e_end;
  limit_state(c, path.strain, contracting, y);
  stress = {select(slow, -(y.p + y.s.rr), stress.rr), select(slow, -(y.p + y.s.zz), stress.zz),
            select(slow, y.s.rr + y.s.zz - y.p, stress.tt), select(slow, -y.s.rz, stress.rz)};
}

/// Updates the pack at `k`; returns its P-wave moduli [Pa].
CPT_INLINE Pack update_pack(const Constants& c, const Batch& batch, decltype(batch.size) k) {
  Stress stress = {load(batch.s_rr + k), load(batch.s_zz + k), load(batch.s_tt + k), load(batch.s_rz + k)};
  const Pack e = load(batch.e + k), p_i = load(batch.p_i + k);
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
  path.start = y;
  path.strain = strain;
  path.e_growth = e_growth;
  const Pack p_start = at_least(y.p, splat(c.p_min));
  const Pack G = shear_modulus(c, log(p_start), e + 0.5 * e_growth);
  path.two_G = 2.0 * G;
  path.K = c.K_over_G * G;
  path.x = path.K * strain.v / p_start;
  const Pack factor = secant_factor(c, path.x);
  const Pack dp = factor * (path.K * strain.v);
  const Deviator ds = (factor * path.two_G) * strain.d;
  State end = {y.p + dp, y.s + ds, y.p_i, e_end};
  stress = {stress.rr - (dp + ds.rr), stress.zz - (dp + ds.zz), stress.tt - (dp - ds.rr - ds.zz),
            stress.rz - ds.rz};

  Pack p = at_least(end.p, splat(c.p_min));
  Pack log_p = log(p);
  const Image image = image_at(c, y.p_i, e_end);
  const Pack F = yield_value(c, p, log_p, end.s, image);
  const Mask slow = greater(F, splat(yield_tolerance)) | loose | less(end.p, splat(c.p_min)) |
                    greater(excess_over_cap(c, image, log_p), splat(cap_tolerance));
  if (any(slow)) {
    State settled;
    update_slowly(c, path, end, F, slow, contracting, e_end, settled, stress);
    end = select(slow, settled, end);
    log_p = select(slow, log(at_least(end.p, splat(c.p_min))), log_p);
  }

  store(batch.s_rr + k, stress.rr + poison);
  store(batch.s_zz + k, stress.zz + poison);
  store(batch.s_tt + k, stress.tt + poison);
  store(batch.s_rz + k, stress.rz + poison);
  store(batch.e + k, e_end + poison);
  store(batch.p_i + k, end.p_i + poison);
  return (c.K_over_G + 4.0 / 3.0) * shear_modulus(c, log_p, e_end);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

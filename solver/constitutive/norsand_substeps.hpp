// NorSand's integration of one strain increment through yield: sub-steps with error control and drift
// correction after Sloan, Abbo & Sheng, Engineering Computations 18 (2001) 121-154.
//
// A sub-step is modified Euler, its error that of Euler's method. Where this is too large a third stage makes
// it the third-order method of Shu & Osher, J. Comput. Phys. 77 (1988) 439-471, and its error that of
// modified Euler.
#pragma once

#include "solver/constitutive/norsand_elastic_path.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double smallest_substep =
    1.0 / 128.0;                            // [-] share of the increment that is taken whatever its error
constexpr double smallest_approach = 1e-6;  // [-] the same on the way to the vertex
constexpr int substep_limit = 640;          // more than the smallest sub-steps and their trials need
constexpr double vertex_size = 1e-4;        // [-] q / p up to which a state counts as on the axis
constexpr double small_deviator = 1e-4;     // [-] s : s / p^2 below which its errors are relative to p
constexpr int drift_limit = 8;

/// A strain increment from some state on.
struct Loading {
  Base base;  // a state near all those of the increment
  Strain strain;
  Pack e_growth;  // [-]
};

CPT_INLINE Powers powers_of(const Constants& c, const Base& base, const State& y) {
  return powers_near(c, base, at_least(y.p, splat(c.p_min)), y.p_i);
}
CPT_INLINE void flow_under(const Constants& c, const Loading& loading, const State& y, Mask on_vertex,
                           Flow& f) {
  flow_at(c, y, powers_of(c, loading.base, y), loading.strain.d, on_vertex, f);
}

struct Increment {
  Pack p;
  Deviator s;
  Pack p_i;
};
CPT_INLINE Increment operator+(const Increment& a, const Increment& b) {
  return {a.p + b.p, a.s + b.s, a.p_i + b.p_i};
}
CPT_INLINE Increment operator-(const Increment& a, const Increment& b) {
  return {a.p - b.p, a.s - b.s, a.p_i - b.p_i};
}
CPT_INLINE Increment operator*(double f, const Increment& a) { return {f * a.p, f * a.s, f * a.p_i}; }

/// Elastic-plastic increment for a fraction h of the strain.
CPT_INLINE Increment increment_at(const Flow& f, const Loading& loading, Pack h) {
  const Strain& strain = loading.strain;
  const Pack two_G = 2.0 * f.G;
  const Pack load = f.K * f.n_p * strain.v + two_G * contract(f.n, strain.d) + f.yield_e * loading.e_growth;
  const Pack multiplier = h * at_least(load * reciprocal(f.stiffness), splat(0.0));
  return {f.K * (h * strain.v - multiplier * f.n_p), two_G * (h * strain.d - multiplier * f.m),
          multiplier * f.hardening};
}
CPT_INLINE State step(const Constants& c, const State& y, const Increment& d, Pack e_growth) {
  return {y.p + d.p, y.s + d.s, at_least(y.p_i + d.p_i, splat(c.p_i_min)), y.e + e_growth};
}

struct Substep {
  State end;
  Pack error2;  // [-] square of the relative error
  Pack
      turn;  // [-] fraction of the sub-step, linearly, at which the deviator turns round; 1 where it does not
  Mask third_order;  // lanes that needed the third stage
};

CPT_INLINE Pack relative_error2(const Constants& c, const Increment& error, const State& end) {
  const Pack p = at_least(end.p, splat(c.p_min));
  const Pack p2 = p * p, p_i2 = end.p_i * end.p_i;
  const Pack s2 = contract(end.s, end.s) + small_deviator * p2;
  const Pack inverse = reciprocal(p2 * p_i2 * s2);
  return inverse * ((error.p * error.p * p_i2 + error.p_i * error.p_i * p2) * s2 +
                    contract(error.s, error.s) * (p2 * p_i2));
}

/// One sub-step from y, where the flow is f, over a fraction h. Only `lanes_on` decide whether a third stage
/// is made.
[[maybe_unused]] static void advance(const Constants& c, const State& y, const Flow& f,
                                     const Loading& loading, Pack h, Mask lanes_on, Mask on_vertex,
                                     Substep& result) {
  const Increment d1 = increment_at(f, loading, h);
  const State middle = step(c, y, d1, h * loading.e_growth);
  Flow other;
  flow_under(c, loading, middle, on_vertex, other);
  const Increment d2 = increment_at(other, loading, h);
  const Increment mean = 0.5 * (d1 + d2);
  State end = step(c, y, mean, h * loading.e_growth);
  Pack error2 = relative_error2(c, 0.5 * (d2 - d1), end);
  const Mask third_order = lanes_on & !at_most_mask(error2, splat(c.tolerance * c.tolerance));
  if (any(third_order)) {
    flow_under(c, loading, step(c, y, 0.5 * mean, (0.5 * h) * loading.e_growth), on_vertex, other);
    const Increment correction = (2.0 / 3.0) * (increment_at(other, loading, h) - mean);
    const State third = step(c, y, mean + correction, h * loading.e_growth);
    error2 = select(third_order, relative_error2(c, correction, third), error2);
    end = select(third_order, third, end);
  }
  result.end = end;
  result.error2 = error2;
  result.third_order = third_order;
  const Pack q = contract(y.s, f.unit);
  const Pack q_end = at_most(contract(middle.s, f.unit), contract(end.s, f.unit));
  const Mask turned = less(q_end, splat(0.0));
  result.turn = splat(1.0);
  if (any(turned)) result.turn = select(turned, at_least(q, splat(0.0)) / (q - q_end), splat(1.0));
}

/// The isotropic vertex (q = 0, p = e p_i). A lane near it stays there if, starting on the axis in the
/// direction of the strain deviator, it is driven back: then plastic flow is volumetric and keeps q = 0.
/// Replaces the sub-step of lanes that stay or that went beyond the axis; returns those that stay.
[[maybe_unused]] static Mask step_near_axis(const Constants& c, const State& now, const Loading& loading,
                                            Pack h, Mask near, Mask beyond, Substep& substep) {
  const State axis = {now.p, Deviator{}, now.p_i, now.e};
  Flow f;
  flow_under(c, loading, axis, none(), f);
  Substep trial;
  advance(c, axis, f, loading, h, near, none(), trial);
  const Mask stays = near & less(trial.turn, splat(1.0));
  substep.end = select(near & beyond, trial.end, substep.end);
  substep.error2 = select(near & beyond, trial.error2, substep.error2);
  if (!any(stays)) return stays;
  flow_under(c, loading, axis, stays, f);
  advance(c, axis, f, {loading.base, {loading.strain.v, Deviator{}}, loading.e_growth}, h, stays, stays,
          trial);
  substep.end = select(stays, trial.end, substep.end);
  substep.error2 = select(stays, trial.error2, substep.error2);
  return stays;
}

/// Brings lanes back to the yield surface at constant strain, starting from the flow at y. Returns those that
/// it moved by more than a rounding of that flow.
[[maybe_unused]] static Mask correct_drift(const Constants& c, const Base& base, State& y, Flow f, Mask off,
                                           Mask on_vertex, bool only_outside) {
  Mask moved = none();
  for (int i = 0; i < drift_limit; ++i) {
    const Pack multiplier = select(off, f.yield * f.p * reciprocal(f.stiffness), splat(0.0));
    y.p -= multiplier * f.K * f.n_p;
    y.s = y.s - (2.0 * f.G * multiplier) * f.m;
    y.p_i = at_least(y.p_i + multiplier * f.hardening, splat(c.p_i_min));
    // What a correction leaves is of the order of the distance squared, over eta near the axis.
    off = off & greater(abs(f.yield), 1e-5 * f.eta);
    if (!any(off)) break;
    moved = moved | off;
    flow_at(c, y, powers_of(c, base, y), Deviator{}, on_vertex, f);  // without strain: along the gradient
    off = off & greater(only_outside ? f.yield : abs(f.yield), splat(yield_tolerance));
    if (!any(off)) break;
  }
  return moved;
}

/// Distance from the yield surface, F / p.
CPT_INLINE Pack yield_of(const Constants& c, const Base& base, const State& y) {
  const Powers w = powers_of(c, base, y);
  return yield_value(c, at_least(y.p, splat(c.p_min)), y.s, w, image_at(c, w, y.e));
}

/// Share of the increment to try first: the elastic trial stress is to move by no more than a third of the
/// stress.
CPT_INLINE Pack first_length(const ElasticPath& path) {
  const State& y = path.start;
  const Pack dp = path.K * path.strain.v;
  const Pack change2 = 3.0 * dp * dp + path.two_G * path.two_G * contract(path.strain.d, path.strain.d);
  const Pack stress2 = 3.0 * y.p * y.p + contract(y.s, y.s);
  const Mask small = at_most_mask(10.0 * change2, stress2);
  if (all(small)) return splat(1.0);
  return select(small, splat(1.0), at_least(inverse_sqrt(10.0 * change2 / stress2), splat(smallest_substep)));
}

/// Carries the lanes of `plastic` from the start of the path to its end through yield; others keep `y`.
[[maybe_unused]] static void integrate_plastic(const Constants& c, const ElasticPath& path, Pack F_1,
                                               Mask plastic, State& y) {
  Loading loading = {path.base, path.strain, path.e_growth};
  State now = path.start;
  Flow f;
  flow_at(c, now, path.base.powers, path.strain.d, none(), f);
  const Mask inside = plastic & less(f.yield, splat(-yield_tolerance));
  const Pack elastic_load = f.K * f.n_p * path.strain.v + 2.0 * f.G * contract(f.n, path.strain.d);
  const Mask reversing = plastic & !inside & less(elastic_load, splat(0.0));
  if (any(inside | reversing)) {
    const Pack t = crossing(c, path, f.yield, F_1, inside, reversing);
    const Mask moved = greater(t, splat(0.0));
    now = select(moved, path.at(c, t), now);
    const Pack rest = select(moved, 1.0 - t, splat(1.0));
    loading.strain = {rest * path.strain.v, rest * path.strain.d};
    loading.e_growth = rest * path.e_growth;
    Flow at_crossing;
    flow_under(c, loading, now, none(), at_crossing);
    f = select(moved, at_crossing, f);
  }

  const double tolerance2 = c.tolerance * c.tolerance;
  Pack done = splat(0.0), length = first_length(path);
  Mask active = plastic;
  for (int i = 0; i < substep_limit; ++i) {
    const bool last = i == substep_limit - 1, late = i >= substep_limit / 2;
    const Pack rest = 1.0 - done;
    const Pack h = last ? rest : at_most(length, rest);
    Substep substep;
    advance(c, now, f, loading, h, active, none(), substep);

    // A sub-step beyond the axis is shortened until it ends near it; there the vertex takes over.
    const Mask beyond = less(substep.turn, splat(1.0));
    const Mask approached = late ? beyond : beyond & at_most_mask(h, splat(smallest_approach));
    const Mask near = active & (approached | at_most_mask(1.5 * contract(now.s, f.unit), vertex_size * f.p));
    const Mask too_far = beyond & !near;
    Mask on_vertex = none();
    if (any(near)) on_vertex = step_near_axis(c, now, loading, h, near, beyond, substep);

    const Mask undefined = !at_most_mask(substep.error2, splat(1e300));
    const Mask taken = last ? active : at_most_mask(h, splat(smallest_substep)) | undefined;
    const Mask accepted = active & !too_far & (at_most_mask(substep.error2, splat(tolerance2)) | taken);
    const Mask ended = accepted & (less(substep.end.p, splat(c.p_min)) | at_most_mask(rest, h) | undefined);
    const bool more = any(active & !ended);
    const Mask off = accepted & greater(abs(yield_of(c, path.base, substep.end)), splat(yield_tolerance));
    Flow at_end;
    if (more || any(off)) flow_under(c, loading, substep.end, on_vertex, at_end);
    Mask moved = none();
    if (any(off)) moved = correct_drift(c, path.base, substep.end, at_end, off, on_vertex, false);
    now = select(accepted, substep.end, now);
    done = select(accepted, done + h, done);
    active = active & !ended;
    if (!more) break;
    const Mask stale = accepted & (moved | on_vertex);
    if (any(stale)) {
      Flow again;
      flow_under(c, loading, now, none(), again);
      at_end = select(stale, again, at_end);
    }
    f = select(accepted, at_end, f);

    const Pack ratio = tolerance2 / at_least(substep.error2, splat(1e-40));
    const Pack third = 0.9 * exp((1.0 / 6.0) * log(ratio));
    const Pack growth =
        select(substep.third_order, at_most(at_least(third, splat(0.1)), splat(2.0)), splat(2.0));
    length = select(too_far, h * (0.999 * substep.turn), at_least(h * growth, splat(smallest_substep)));
  }
  y = select(plastic, now, y);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

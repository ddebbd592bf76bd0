// The elastic path of a strain increment, in closed form, and where it leaves the yield surface.
#pragma once

#include "solver/constitutive/norsand_surface.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double yield_tolerance = 1e-7;  // [-] |F| / p that counts as on the surface
constexpr int crossing_limit = 30;

/// p along the elastic path over the growth that the initial modulus gives: ((1 + (1-b) x)^(1/(1-b)) - 1) / x
/// with x = K dv / p. The deviator follows in proportion, because G / K is constant.
CPT_INLINE Pack secant_factor(const Constants& c, Pack x) {
  const double* k = c.secant;
  const Pack x2 = x * x;
  const Pack series =
      ((k[0] + x * k[1]) + x2 * (k[2] + x * k[3])) + (x2 * x2) * ((k[4] + x * k[5]) + x2 * k[6]);
  const Mask small = at_most_mask(abs(x), splat(series_range));
  if (all(small)) return series;
  const double power = 1.0 - c.b;
  const Pack base = at_least(1.0 + power * x, splat(1e-30));
  const Pack exact = (exp(log(base) * (1.0 / power)) - 1.0) / select(small, splat(1.0), x);
  return select(small, series, exact);
}

/// The elastic path of an increment, from its start to a fraction t of it.
struct ElasticPath {
  Base base;  // at the start
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

/// Fraction of the increment at which the elastic path leaves the yield surface for the last time.
[[maybe_unused]] static Pack crossing(const Constants& c, const ElasticPath& path, Pack F_0, Pack F_1,
                                      Mask inside, Mask reversing) {
  const auto yield_at = [&](Pack t) __attribute__((always_inline)) {
    const State y = path.at(c, t);
    const Pack p = at_least(y.p, splat(c.p_min));
    const Powers w = powers_near(c, path.base, p, y.p_i);
    return yield_value(c, p, y.s, w, image_at(c, w, y.e));
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

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

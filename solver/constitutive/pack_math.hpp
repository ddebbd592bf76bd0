// Natural logarithm and exponential of a pack, within 2 units in the last place.
//
// Both need no fused multiply-add. Sources: the argument reduction and the coefficients of log are those of
// FreeBSD's msun (e_log.c, Sun Microsystems 1993); exp is its Taylor series on |r| <= ln(2)/2.
#pragma once

#include "solver/constitutive/pack.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double ln2_high = 6.93147180369123816490e-01;  // the last 32 bits are zero
constexpr double ln2_low = 1.90821492927058770002e-10;

/// ln(x) of a positive normal number; NaN of anything else.
CPT_INLINE Pack log(Pack x) {
  // x = 2^k (1 + f), sqrt(1/2) <= 1 + f < sqrt(2).
  constexpr unsigned long long sqrt_half = 0x3fe6a09e667f3bcdULL;
  const Bits bits = reinterpret_cast<Bits>(x);
  const Bits biased = (bits - sqrt_half + (1024ULL << 52)) >> 52;  // k + 1024
  const Pack k = reinterpret_cast<Pack>(biased | 0x4330000000000000ULL) - (4503599627370496.0 + 1024.0);
  const Pack f = reinterpret_cast<Pack>(bits - ((biased - 1024ULL) << 52)) - 1.0;
  const Pack s = f * reciprocal(2.0 + f);
  const Pack z = s * s, w = z * z;
  const Pack odd =
      w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const Pack even =
      z * (6.666666666666735130e-01 +
           w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const Pack half_square = 0.5 * f * f;
  const Pack value = k * ln2_high - ((half_square - (s * (half_square + (odd + even)) + k * ln2_low)) - f);
  const Mask valid = less(splat(0.0), x) & less(x, splat(__builtin_inf()));
  return select(valid, value, splat(__builtin_nan("")));
}

/// e^x; x is limited to [-700, 700], NaN stays NaN.
CPT_INLINE Pack exp(Pack x) {
  x = at_most(at_least(x, splat(-700.0)), splat(700.0));
  constexpr double to_integer =
      6755399441055744.0;  // 1.5 * 2^52: the sum's last bits are the nearest integer
  const Pack shifted = x * 1.4426950408889634 + to_integer;
  const Pack k = shifted - to_integer;
  const Pack r = (x - k * ln2_high) - k * ln2_low;
  const Pack r2 = r * r, r4 = r2 * r2;
  const Pack c01 = 1.0 / 2.0 + r * (1.0 / 6.0);
  const Pack c23 = 1.0 / 24.0 + r * (1.0 / 120.0);
  const Pack c45 = 1.0 / 720.0 + r * (1.0 / 5040.0);
  const Pack c67 = 1.0 / 40320.0 + r * (1.0 / 362880.0);
  const Pack c89 = 1.0 / 3628800.0 + r * (1.0 / 39916800.0);
  const Pack c1011 = 1.0 / 479001600.0 + r * (1.0 / 6227020800.0);
  const Pack series = (c01 + r2 * c23) + r4 * ((c45 + r2 * c67) + r4 * (c89 + r2 * c1011));
  const Pack value = 1.0 + (r + r2 * series);
  const Bits power = (reinterpret_cast<Bits>(shifted) << 52) + 0x3ff0000000000000ULL;
  return value * reinterpret_cast<Pack>(power);
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

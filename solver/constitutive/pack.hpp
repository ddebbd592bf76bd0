// A pack: as many doubles as one vector register of the instruction set this file is compiled for holds.
//
// Arithmetic is that of GCC's vector extension; masks, selections and roots are given here. Every function is
// internal and inlined, so that code for one instruction set cannot be linked into a program built for
// another. Each lane depends on its own data only. Compile with CPT_KERNEL_NAMESPACE defined.
#pragma once

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#if !defined(CPT_KERNEL_NAMESPACE) || !defined(CPT_PACK_BYTES)
#error "define CPT_KERNEL_NAMESPACE and CPT_PACK_BYTES before including a kernel"
#endif

#define CPT_INLINE [[maybe_unused]] static inline __attribute__((always_inline))

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr int pack_bytes = CPT_PACK_BYTES;
constexpr int lanes = pack_bytes / 8;

typedef double Pack __attribute__((vector_size(pack_bytes)));
typedef unsigned long long Bits __attribute__((vector_size(pack_bytes)));

CPT_INLINE Pack splat(double x) {
  Pack r;
  for (int i = 0; i < lanes; ++i) r[i] = x;
  return r;
}

CPT_INLINE Pack load(const double* x) { return *reinterpret_cast<const Pack*>(x); }    // aligned
CPT_INLINE void store(double* x, Pack value) { *reinterpret_cast<Pack*>(x) = value; }  // aligned

#if CPT_PACK_BYTES == 64

struct Mask {
  __mmask8 bits;
};
CPT_INLINE Mask operator&(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
CPT_INLINE Mask operator|(Mask a, Mask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
CPT_INLINE Mask operator!(Mask a) { return {static_cast<__mmask8>(~a.bits)}; }
CPT_INLINE bool any(Mask a) { return a.bits != 0; }
CPT_INLINE Mask none() { return {0}; }
CPT_INLINE Mask less(Pack a, Pack b) { return {_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ)}; }
CPT_INLINE Mask at_most_mask(Pack a, Pack b) { return {_mm512_cmp_pd_mask(a, b, _CMP_LE_OQ)}; }
CPT_INLINE Pack select(Mask m, Pack a, Pack b) { return _mm512_mask_blend_pd(m.bits, b, a); }
CPT_INLINE Pack at_least(Pack x, Pack low) { return _mm512_mask_max_pd(x, 0xff, low, x); }
CPT_INLINE Pack at_most(Pack x, Pack high) { return _mm512_mask_min_pd(x, 0xff, high, x); }
/// 1 / x and 1 / sqrt(x) of a positive normal x, within 2 units in the last place: the processor's estimate
/// to 14 bits, then Newton's method of third and second order. Division and square root themselves take
/// several times longer.
CPT_INLINE Pack reciprocal(Pack x) {
  Pack y = _mm512_mask_rcp14_pd(x, 0xff, x);
  const Pack error = 1.0 - x * y;
  y = y + y * (error + error * error);
  return y + y * (1.0 - x * y);
}
CPT_INLINE Pack exact_sqrt(Pack x) { return _mm512_mask_sqrt_pd(x, 0xff, x); }
CPT_INLINE Pack inverse_sqrt(Pack x) {
  Pack y = _mm512_mask_rsqrt14_pd(x, 0xff, x);
  const Pack error = 1.0 - x * (y * y);
  y = y + y * (error * (0.5 + 0.375 * error));
  return y + y * (0.5 * (1.0 - x * (y * y)));
}

#else

struct Mask {
  Bits bits;
};
CPT_INLINE Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
CPT_INLINE Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
CPT_INLINE Mask operator!(Mask a) { return {~a.bits}; }
CPT_INLINE Mask none() { return {Bits{}}; }
CPT_INLINE Mask less(Pack a, Pack b) { return {reinterpret_cast<Bits>(a < b)}; }
CPT_INLINE Mask at_most_mask(Pack a, Pack b) { return {reinterpret_cast<Bits>(a <= b)}; }

#if CPT_PACK_BYTES == 32
CPT_INLINE bool any(Mask a) { return _mm256_movemask_pd(reinterpret_cast<Pack>(a.bits)) != 0; }
CPT_INLINE Pack select(Mask m, Pack a, Pack b) {
  return _mm256_blendv_pd(b, a, reinterpret_cast<Pack>(m.bits));
}
CPT_INLINE Pack at_least(Pack x, Pack low) { return _mm256_max_pd(low, x); }
CPT_INLINE Pack at_most(Pack x, Pack high) { return _mm256_min_pd(high, x); }
CPT_INLINE Pack exact_sqrt(Pack x) { return _mm256_sqrt_pd(x); }
#else
CPT_INLINE bool any(Mask a) { return (a.bits[0] | a.bits[1]) != 0; }
CPT_INLINE Pack select(Mask m, Pack a, Pack b) {
  return reinterpret_cast<Pack>((m.bits & reinterpret_cast<Bits>(a)) | (~m.bits & reinterpret_cast<Bits>(b)));
}
CPT_INLINE Pack at_least(Pack x, Pack low) { return select(less(x, low), low, x); }
CPT_INLINE Pack at_most(Pack x, Pack high) { return select(less(high, x), high, x); }
#if defined(__x86_64__)
CPT_INLINE Pack exact_sqrt(Pack x) { return _mm_sqrt_pd(x); }
#else
CPT_INLINE Pack exact_sqrt(Pack x) { return Pack{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])}; }
#endif
#endif
CPT_INLINE Pack inverse_sqrt(Pack x) { return 1.0 / exact_sqrt(x); }
CPT_INLINE Pack reciprocal(Pack x) { return 1.0 / x; }

#endif

/// sqrt(x) of a positive normal x, within 2 units in the last place.
CPT_INLINE Pack positive_sqrt(Pack x) { return x * inverse_sqrt(x); }

CPT_INLINE Mask greater(Pack a, Pack b) { return less(b, a); }
CPT_INLINE bool all(Mask a) { return !any(!a); }
CPT_INLINE Pack abs(Pack x) {
  return reinterpret_cast<Pack>(reinterpret_cast<Bits>(x) & 0x7fffffffffffffffULL);
}
CPT_INLINE double largest(Pack x) {
  double r = x[0];
  for (int i = 1; i < lanes; ++i) r = x[i] > r ? x[i] : r;
  return r;
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

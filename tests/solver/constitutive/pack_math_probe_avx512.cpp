#if defined(__x86_64__)
#include "tests/solver/constitutive/pack_math_probe.hpp"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,fma"))), \
                             apply_to = function)
#else
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw,fma")
#endif
#define CPT_PACK_BYTES 64
#define CPT_KERNEL_NAMESPACE probe_for_avx512
#include "solver/constitutive/pack_math.hpp"

namespace cpt::solver {
void probe_avx512(const double* x, double* logarithm, double* exponential) {
  using namespace probe_for_avx512;
  for (int i = 0; i < 8; i += lanes) {
    store(logarithm + i, log(load(x + i)));
    store(exponential + i, exp(load(x + i)));
  }
}
}  // namespace cpt::solver

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif

// The kernels for processors with AVX512. Headers that are not the kernels' own come before the pragma.
#if defined(__x86_64__)
#include "solver/constitutive/kernels.hpp"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,fma"))), \
                             apply_to = function)
#else
#pragma GCC target("avx512f,avx512dq,avx512vl,avx512bw,fma")
#endif
#define CPT_PACK_BYTES 64
#define CPT_KERNEL_NAMESPACE kernels_for_avx512
#include "solver/constitutive/kernel_table.hpp"

namespace cpt::solver {
const ConstitutiveKernels constitutive_kernels_avx512 = {
    kernels_for_avx512::update_norsand, kernels_for_avx512::evaluate_norsand,
    kernels_for_avx512::update_tresca, kernels_for_avx512::update_varying_tresca,
    kernels_for_avx512::update_linear_elastic};
}  // namespace cpt::solver

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif

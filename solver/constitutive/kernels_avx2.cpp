// The kernels for processors with AVX2. Headers that are not the kernels' own come before the pragma.
#if defined(__x86_64__)
#include "solver/constitutive/kernels.hpp"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC target("avx2,fma")
#endif
#define CPT_PACK_BYTES 32
#define CPT_KERNEL_NAMESPACE kernels_for_avx2
#include "solver/constitutive/kernel_table.hpp"

namespace cpt::solver {
const ConstitutiveKernels constitutive_kernels_avx2 = {
    kernels_for_avx2::update_norsand, kernels_for_avx2::evaluate_norsand, kernels_for_avx2::update_tresca,
    kernels_for_avx2::update_varying_tresca, kernels_for_avx2::update_linear_elastic};
}  // namespace cpt::solver

#if defined(__clang__)
#pragma clang attribute pop
#endif
#endif

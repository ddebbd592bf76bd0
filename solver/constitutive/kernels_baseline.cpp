// The kernels for any processor.
#define CPT_PACK_BYTES 16
#define CPT_KERNEL_NAMESPACE kernels_for_baseline
#include "solver/constitutive/kernel_table.hpp"

namespace cpt::solver {
const ConstitutiveKernels constitutive_kernels_baseline = {
    kernels_for_baseline::update_norsand, kernels_for_baseline::evaluate_norsand,
    kernels_for_baseline::update_tresca, kernels_for_baseline::update_varying_tresca,
    kernels_for_baseline::update_linear_elastic};
}  // namespace cpt::solver

#include "tests/solver/constitutive/pack_math_probe.hpp"

#define CPT_PACK_BYTES 16
#define CPT_KERNEL_NAMESPACE probe_for_baseline
#include "solver/constitutive/pack_math.hpp"

namespace cpt::solver {
void probe_baseline(const double* x, double* logarithm, double* exponential) {
  using namespace probe_for_baseline;
  for (int i = 0; i < 8; i += lanes) {
    store(logarithm + i, log(load(x + i)));
    store(exponential + i, exp(load(x + i)));
  }
}
}  // namespace cpt::solver

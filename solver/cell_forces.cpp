#include "solver/cell_forces.hpp"

#include "solver/instruction_set.hpp"

namespace cpt::solver {

namespace kernels_for_baseline {
extern const CellForceKernel cell_forces;
}
#if defined(__x86_64__)
namespace kernels_for_avx2 {
extern const CellForceKernel cell_forces;
}
namespace kernels_for_avx512 {
extern const CellForceKernel cell_forces;
}
#endif

CellForceKernel cell_force_kernel() {
#if defined(__x86_64__)
  if (instruction_set() == InstructionSet::avx512) return kernels_for_avx512::cell_forces;
  if (instruction_set() == InstructionSet::avx2) return kernels_for_avx2::cell_forces;
#endif
  return kernels_for_baseline::cell_forces;
}

}  // namespace cpt::solver

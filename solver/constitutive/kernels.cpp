#include "solver/constitutive/kernels.hpp"

#include "solver/instruction_set.hpp"

namespace cpt::solver {

const ConstitutiveKernels& constitutive_kernels() {
#if defined(__x86_64__)
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return constitutive_kernels_avx512;
    case InstructionSet::avx2:
      return constitutive_kernels_avx2;
    case InstructionSet::baseline:
      break;
  }
#endif
  return constitutive_kernels_baseline;
}

}  // namespace cpt::solver

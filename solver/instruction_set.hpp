// Which instruction set the kernels run on, found once at start.
#pragma once

#include <string_view>

namespace cpt::solver {

enum class InstructionSet { baseline, avx2, avx512 };

/// The best one that this processor has; the environment variable CPT_INSTRUCTION_SET (baseline, avx2,
/// avx512) lowers it, for comparing them on one machine.
[[nodiscard]] InstructionSet instruction_set();
[[nodiscard]] std::string_view to_string(InstructionSet set);

}  // namespace cpt::solver

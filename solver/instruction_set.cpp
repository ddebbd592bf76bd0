#include "solver/instruction_set.hpp"

#include <algorithm>
#include <cstdlib>

namespace cpt::solver {
namespace {

InstructionSet supported() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}

InstructionSet chosen() {
  const char* name = std::getenv("CPT_INSTRUCTION_SET");
  const std::string_view wanted = name ? name : "";
  for (const auto set : {InstructionSet::baseline, InstructionSet::avx2})
    if (wanted == to_string(set)) return std::min(set, supported());
  return supported();
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet set = chosen();
  return set;
}

std::string_view to_string(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    default:
      return "baseline";
  }
}

}  // namespace cpt::solver

// Packs as rows of a square: transposed, and summed each over its lanes.
#pragma once

#include <utility>

#include "solver/constitutive/pack.hpp"

/// A quantity's place among the doubles of its struct; needs <cstddef>.
#define CPT_FIELD(Struct, member) (offsetof(Struct, member) / sizeof(double))

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

using LaneIndices = std::make_integer_sequence<int, lanes>;

/// Of every `s` lanes in turn, the first s of a, then the first s of b.
template <int s, int... j>
CPT_INLINE Pack join_first(Pack a, Pack b, std::integer_sequence<int, j...>) {
  return __builtin_shufflevector(a, b, ((j & s) != 0 ? lanes + j - s : j)...);
}
/// The same with the second s of each.
template <int s, int... j>
CPT_INLINE Pack join_second(Pack a, Pack b, std::integer_sequence<int, j...>) {
  return __builtin_shufflevector(a, b, ((j & s) != 0 ? lanes + j : j + s)...);
}

template <int s>
CPT_INLINE void transpose_blocks(Pack (&x)[lanes]) {
  if constexpr (s > 0) {
    for (int j = 0; j < lanes; ++j) {
      if ((j & s) != 0) continue;
      const Pack a = x[j], b = x[j + s];
      x[j] = join_first<s>(a, b, LaneIndices{});
      x[j + s] = join_second<s>(a, b, LaneIndices{});
    }
    transpose_blocks<s / 2>(x);
  }
}
/// Lane i of pack j becomes lane j of pack i.
CPT_INLINE void transpose(Pack (&x)[lanes]) { transpose_blocks<lanes / 2>(x); }

/// Lane j of the result is the sum of the lanes of x[j], first to last.
CPT_INLINE Pack lane_sums(Pack (&x)[lanes]) {
  transpose(x);
  Pack sum = x[0];
  for (int i = 1; i < lanes; ++i) sum += x[i];
  return sum;
}
/// The sum of the lanes, first to last.
CPT_INLINE double lane_sum(Pack x) {
  double sum = x[0];
  for (int i = 1; i < lanes; ++i) sum += x[i];
  return sum;
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

// Numbers that look random and depend on an identity alone: the same for any number of threads and ranks.
#pragma once

#include <cstdint>

namespace cpt::solver {

/// The next state of SplitMix64 (Steele, Lea & Flood 2014), scrambled.
[[nodiscard]] constexpr std::uint64_t hashed(std::uint64_t x) {
  x = (x + 1) * 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// In [0, 1).
[[nodiscard]] constexpr double hashed_unit(std::uint64_t x) {
  return static_cast<double>(hashed(x) >> 11) * 0x1.0p-53;
}

}  // namespace cpt::solver

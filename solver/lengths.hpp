// Lengths compared with one another or with multiples of a cell, a bin or a row.
//
// Lengths of a file are decimal numbers; their differences and multiples are right to the last few of sixteen
// digits only: 0.088 - 0.038 falls short of ten cells of 0.005 by 7e-18. A length that misses a bound by no
// more than a billionth of it meets it.
#pragma once

namespace cpt::solver {

inline constexpr double length_rounding = 1.0e-9;  // [-] of the bound

/// Below the bound by more than rounding.
[[nodiscard]] constexpr bool falls_short(double length, double least) {
  return length < least * (1.0 - length_rounding);
}

/// Above the bound by more than rounding.
[[nodiscard]] constexpr bool exceeds(double length, double most) {
  return length > most * (1.0 + length_rounding);
}

}  // namespace cpt::solver

// The zero of the sleeve's load cell is off from the start: every reading of f_s is too high or too low by
// the same amount.
//
//   f_recorded = f_s + offset      ISO 22476-1 (2012), 6.2 and Table 2: readings of zero, accuracy
#pragma once

namespace cpt::solver {

struct SleeveOffset {
  double offset = 0.0;  // [Pa]
};

}  // namespace cpt::solver

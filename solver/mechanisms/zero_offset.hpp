// The load cell's zero is off from the start: every reading of q_c is too high or too low by the same amount.
//
//   q_recorded = q_c + offset      ISO 22476-1 (2012), 6.2 and Table 2: readings of zero, accuracy
#pragma once

namespace cpt::solver {

struct ZeroOffset {
  double offset = 0.0;  // [Pa]
};

}  // namespace cpt::solver

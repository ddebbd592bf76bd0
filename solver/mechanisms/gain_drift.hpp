// The load cell's gain drifts while the cone goes down, as warming or a damaged strain gauge make it do.
//
//   q_recorded = q_c (1 + drift z / z_final)   ISO 22476-1 (2012), Table 2: accuracy in per cent of the
//   reading
#pragma once

namespace cpt::solver {

struct GainDrift {
  double at_end = 0.0;  // [-] at the final depth
};

}  // namespace cpt::solver

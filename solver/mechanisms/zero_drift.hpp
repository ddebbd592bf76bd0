// The load cell's zero drifts while the cone goes down, as temperature or moisture make it do.
//
//   q_recorded = q_c + drift z / z_final      ISO 22476-1 (2012), 6.2 and Table 2: zero drift, accuracy
#pragma once

namespace cpt::solver {

struct ZeroDrift {
  double at_end = 0.0;  // [Pa] at the final depth
};

}  // namespace cpt::solver

// Material points of one soil in structure-of-arrays form, as the time loop hands them to a constitutive law.
#pragma once

#include <cstddef>

namespace cpt::solver {

/// `size` is a multiple of `batch_width`; the tail holds harmless dummy points (valid state, zero strain).
/// Arrays are 64-byte aligned and do not overlap. Axisymmetric components (r, z, theta; shear rz as tensor
/// component, not engineering strain). Stresses are already rotated (Jaumann) when a law sees them.
struct Batch {
  std::size_t size;
  double* s_rr;  // [Pa] stress, tension-positive
  double* s_zz;
  double* s_tt;
  double* s_rz;
  double* e;           // [-] void ratio
  double* h_0;         // first state variable of the law (soils/law.hpp)
  const double* d_rr;  // [-] strain increment of the step, tension-positive
  const double* d_zz;
  const double* d_tt;
  const double* d_rz;
  double* h_1 = nullptr;  // second state variable
  double dt = 0.0;        // [s] duration of the step; 0 for none
};

inline constexpr std::size_t batch_width = 8;

}  // namespace cpt::solver

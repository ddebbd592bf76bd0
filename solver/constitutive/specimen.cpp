#include "solver/constitutive/specimen.hpp"

#include <algorithm>

namespace cpt::solver {

void Specimen::strain(double d_rr, double d_zz, double d_tt, double d_rz) {
  // A batch of equal points.
  constexpr std::size_t field_count = 11;
  const double fields[field_count] = {stress_.rr, stress_.zz, stress_.tt, stress_.rz, e_,  h_0_,
                                      d_rr,       d_zz,       d_tt,       d_rz,       h_1_};
  alignas(64) double f[field_count][batch_width];
  for (std::size_t i = 0; i < field_count; ++i) std::fill_n(f[i], batch_width, fields[i]);
  modulus_ = update_({batch_width, f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10]});
  stress_ = {f[0][0], f[1][0], f[2][0], f[3][0]};
  e_ = f[4][0];
  h_0_ = f[5][0];
  h_1_ = f[10][0];
}

}  // namespace cpt::solver

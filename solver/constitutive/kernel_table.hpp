// Body of kernels_*.cpp: the table of kernels for the instruction set in force.
#pragma once

#include "solver/constitutive/kernels.hpp"
#include "solver/constitutive/norsand_kernel.hpp"
#include "solver/constitutive/tresca_kernel.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

[[maybe_unused]] static double update_norsand(const NorSandConstants& c, const Batch& batch) {
  Pack modulus = splat(0.0);
  for (decltype(batch.size) k = 0; k < batch.size; k += lanes)
    modulus = at_least(update_pack(c, batch, k), modulus);
  return largest(modulus);
}

[[maybe_unused]] static NorSandState evaluate_norsand(const NorSandConstants& c, const PointStress& stress,
                                                      double e, double p_i) {
  State y;
  y.p = splat((stress.rr + stress.zz + stress.tt) * (-1.0 / 3.0));
  y.s = {-stress.rr - y.p, -stress.zz - y.p, splat(-stress.rz)};
  y.p_i = splat(p_i);
  y.e = splat(e);
  Flow f;
  flow_at(c, y, Deviator{}, none(), f);
  const Image at_p = image_at(c, f.p, y.e);
  const Pack q = sqrt(1.5 * contract(y.s, y.s));
  const Pack M_i = f.n_p + q / f.p;
  return {
      y.p[0],           q[0],   13.5 * determinant(f.unit)[0],    at_p.psi[0], f.image.psi[0], f.image.chi[0],
      f.image.M_itc[0], M_i[0], (f.p * exp(f.image.log_p_mx))[0], f.n_p[0],    f.G[0],         f.K[0],
      f.yield[0]};
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

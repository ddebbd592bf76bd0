// Body of kernels_*.cpp: the table of kernels for the instruction set in force.
#pragma once

#include "solver/constitutive/kernels.hpp"
#include "solver/constitutive/norsand_kernel.hpp"
#include "solver/constitutive/tresca_kernel.hpp"

namespace cpt::solver::CPT_KERNEL_NAMESPACE {

constexpr double near_yield = 1e-4;  // [-] |F| / p of a point that yields, for what only reports it

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
  const Pack p = at_least(y.p, splat(c.p_min));
  const Powers w = powers_at(c, p, y.p_i);
  Flow f;
  flow_at(c, y, w, Deviator{}, none(), f);
  const Image image = image_at(c, w, y.e), at_p = image_at(c, powers_at(c, p, p), y.e);
  const Pack q = f.eta * f.p;
  const Pack elastic = f.K * f.n_p * f.n_p + 2.0 * f.G * contract(f.n, f.m);
  const bool held = image.D[0] <= smallest_chi_denominator ||
                    image.M_itc_D[0] <= least_M * c.M_tc * image.D[0] || e - c.e_min_star <= smallest_gap;
  const bool soft = f.yield[0] > -near_yield &&
                    f.stiffness[0] < 1.000001 * least_stiffness * elastic[0];  // but for rounding
  return {y.p[0],
          q[0],
          13.5 * determinant(f.unit)[0],
          at_p.psi[0],
          image.psi[0],
          (c.chi_tc / image.D)[0],
          (image.M_itc_D / image.D)[0],
          f.M_i[0],
          (f.p * exp(-c.chi_tc * image.psi / image.M_itc_D))[0],
          f.n_p[0],
          f.G[0],
          f.K[0],
          f.yield[0],
          held || soft};
}

}  // namespace cpt::solver::CPT_KERNEL_NAMESPACE

// The stress updates as compiled for one instruction set, and what they read.
//
// kernels_baseline.cpp, kernels_avx2.cpp and kernels_avx512.cpp hold the same code; one of them is chosen at
// start.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/norsand_constants.hpp"

namespace cpt::solver {

struct ElasticConstants {
  double lame;   // [Pa] K - 2 G / 3
  double two_G;  // [Pa]
};

struct TrescaConstants {
  ElasticConstants elastic;
  double s_u;  // [Pa] undrained shear strength
};

/// Tresca with a strength of its own at every point, by strain and rate.
struct VaryingTrescaConstants {
  ElasticConstants elastic;
  double loss;                    // [-] share of the strength lost when fully remoulded
  double inverse_xi_95;           // [-] over the plastic shear strain at which 95 % of it is lost
  double mu;                      // [-] rise of strength per tenfold rate
  double inverse_reference_rate;  // [s]
};

/// Symmetric stress of the axisymmetric components [Pa], tension-positive.
struct PointStress {
  double rr, zz, tt, rz;
};

struct ConstitutiveKernels {
  /// Returns the largest P-wave modulus [Pa] after the update.
  double (*update_norsand)(const NorSandConstants&, const Batch&);
  NorSandState (*evaluate_norsand)(const NorSandConstants&, const PointStress&, double e, double p_i);
  void (*update_tresca)(const TrescaConstants&, const Batch&);
  void (*update_varying_tresca)(const VaryingTrescaConstants&, const Batch&);
  void (*update_linear_elastic)(const ElasticConstants&, const Batch&);
};

/// Those for this machine's instruction set.
[[nodiscard]] const ConstitutiveKernels& constitutive_kernels();

extern const ConstitutiveKernels constitutive_kernels_baseline;
#if defined(__x86_64__)
extern const ConstitutiveKernels constitutive_kernels_avx2;
extern const ConstitutiveKernels constitutive_kernels_avx512;
#endif

}  // namespace cpt::solver

// Tresca for clay whose strength differs from point to point, or follows strain and rate.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"
#include "solver/mechanisms/mechanisms.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

/// Tresca (tresca.hpp) with the strength s_u0 [Pa] of each point in Batch::h_0, times the factors of
/// mechanisms/strain_softening.hpp and mechanisms/rate_dependence.hpp. Keeps the plastic shear strain in
/// Batch::h_1.
class VaryingTresca {
 public:
  VaryingTresca(const TrescaParameters& clay, const StrainSoftening& softening, const RateDependence& rate);

  /// Updates stress, void ratio and plastic shear strain of a batch for one step; returns the P-wave modulus
  /// [Pa].
  double update(const Batch& batch) const {
    kernels_->update_varying_tresca(constants_, batch);
    return modulus_;
  }

 private:
  VaryingTrescaConstants constants_;
  const ConstitutiveKernels* kernels_;
  double modulus_;  // [Pa]
};

/// True if some mechanism or the clay's random field asks for it.
[[nodiscard]] bool strength_varies(const TrescaParameters& clay, const Mechanisms& mechanisms);
/// s_u0 [Pa] at a depth [m].
[[nodiscard]] double strength_at(const TrescaParameters& clay, const Mechanisms& mechanisms, double depth);

}  // namespace cpt::solver

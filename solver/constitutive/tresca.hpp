// Tresca: undrained clay, linear elastic and perfectly plastic.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"
#include "solver/soils/tresca.hpp"

namespace cpt::solver {

/// Hooke's law up to sigma_1 - sigma_3 = 2 s_u, then the exact return to the hexagon with its corners
/// (associated, so that plastic flow keeps the volume).
class Tresca {
 public:
  explicit Tresca(const TrescaParameters& clay);

  /// Updates stress and void ratio of a batch for one step; returns the P-wave modulus K + 4/3 G [Pa], a
  /// constant.
  double update(const Batch& batch) const {
    kernels_->update_tresca(constants_, batch);
    return modulus_;
  }

 private:
  TrescaConstants constants_;
  const ConstitutiveKernels* kernels_;
  double modulus_;  // [Pa]
};

}  // namespace cpt::solver

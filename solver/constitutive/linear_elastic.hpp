// Isotropic linear elasticity: the surcharge layer, and verification.
#pragma once

#include "solver/constitutive/batch.hpp"
#include "solver/constitutive/kernels.hpp"

namespace cpt::solver {

class LinearElastic {
 public:
  /// Young's modulus E > 0 [Pa], Poisson's ratio -1 < nu < 0.5 [-].
  LinearElastic(double E, double nu);

  /// Updates stress and void ratio of a batch for one step; returns the P-wave modulus K + 4/3 G [Pa], a
  /// constant.
  double update(const Batch& batch) const {
    kernels_->update_linear_elastic(constants_, batch);
    return constants_.lame + constants_.two_G;
  }

  /// Lame's constants from the shear modulus [Pa] and Poisson's ratio [-].
  [[nodiscard]] static ElasticConstants constants(double G, double nu) {
    return {2.0 * G * nu / (1.0 - 2.0 * nu), 2.0 * G};
  }

 private:
  ElasticConstants constants_;
  const ConstitutiveKernels* kernels_;
};

}  // namespace cpt::solver

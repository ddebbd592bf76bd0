// Linear elasticity as the law of a material: of the surcharge layer, and in verification. No soil of a study
// has it.
#pragma once

#include <memory>

#include "solver/constitutive/linear_elastic.hpp"
#include "solver/soils/law.hpp"

namespace cpt::solver {

/// Young's modulus E > 0 [Pa], Poisson's ratio -1 < nu < 0.5 [-].
[[nodiscard]] inline std::unique_ptr<const SoilModel> elastic_soil(double E, double nu) {
  class Elasticity : public SoilModel {
   public:
    explicit Elasticity(const LinearElastic& law) : law_(law) {}
    [[nodiscard]] double update(const Batch& batch) const override { return law_.update(batch); }

   private:
    LinearElastic law_;
  };
  return std::make_unique<Elasticity>(LinearElastic(E, nu));
}

}  // namespace cpt::solver

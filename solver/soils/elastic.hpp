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
    Elasticity(double E, double nu) : law_(E, nu), nu_(nu) {}
    [[nodiscard]] double update(const Batch& batch) const override { return law_.update(batch); }
    [[nodiscard]] double poissons_ratio() const override { return nu_; }

   private:
    LinearElastic law_;
    double nu_;
  };
  return std::make_unique<Elasticity>(E, nu);
}

}  // namespace cpt::solver

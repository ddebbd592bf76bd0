#include "solver/actual_setup.hpp"

#include "solver/refinement.hpp"

namespace cpt::solver {

Setup actual_setup(const Setup& setup) {
  Setup actual = setup;
  Mechanisms& mechanisms = actual.mechanisms;
  actual.initial.sigma_v0 *= mechanisms.cushion_transfer.factor();
  actual.initial.sigma_h0 *= mechanisms.cushion_transfer.factor();
  for (Soil& soil : actual.soils)
    if (auto* sand = std::get_if<NorSandParameters>(&soil.parameters))
      sand->OCR *= mechanisms.overconsolidation.factor();
  if (mechanisms.push_speed.on()) {
    for (Soil& soil : actual.soils)
      if (auto* clay = std::get_if<TrescaParameters>(&soil.parameters)) {
        clay->s_u *= mechanisms.push_speed.factor();
        clay->s_u_field.deviation *= mechanisms.push_speed.factor();
      }
    mechanisms.strength_gradient.gradient *= mechanisms.push_speed.factor();
  }
  mechanisms.layer_shift.apply(actual.layers);
  mechanisms.layer_thickness.apply(actual.layers);
  actual.penetrometer.diameter -= mechanisms.worn_cone.diameter_loss;
  actual.penetrometer.apex += mechanisms.worn_cone.apex_increase;
  mechanisms.density_trend.over = mechanisms.stress_ratio_trend.over = setup.penetrometer.final_depth;
  mechanisms.cushion_transfer = {};
  mechanisms.overconsolidation = {};
  mechanisms.push_speed = {};
  mechanisms.layer_shift = {};
  mechanisms.layer_thickness = {};
  mechanisms.worn_cone = {};
  actual.numerics = refined(setup);
  actual.numerics.for_diameter = actual.penetrometer.diameter;  // a worn cone keeps the mesh
  return actual;
}

}  // namespace cpt::solver

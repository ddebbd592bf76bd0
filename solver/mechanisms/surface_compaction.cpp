#include "solver/mechanisms/surface_compaction.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism surface_compaction_mechanism() {
  return {
      .name = "surface_compaction",
      .title = "sand compacted near the surface",
      .equation = "D_r(z) = D_r + increase exp(-z / decay)",
      .source =
          "Yost et al. (2023), section 5.1; range: up to the densest state, a few cushion settlements deep",
      .signature = "q_c is higher near the top, and the difference fades downward over a few decay lengths.",
      .acts_on = norsand_only,
      .parameters = {
          {number<&Setup::mechanisms, &Mechanisms::surface_compaction, &SurfaceCompaction::increase>(
               "surface_compaction.increase_percent", "ΔDᵣ", percent, 0.0, 80.0, norsand_only,
               "increase of the relative density at the soil's top, fading downward",
               "Yost et al. (2023), section 5.1"),
           0.0, 40.0},
          {number<&Setup::mechanisms, &Mechanisms::surface_compaction, &SurfaceCompaction::decay>(
               "surface_compaction.decay_mm", "ℓ", millimetres, 1.0, 2000.0, norsand_only,
               "depth over which the increase falls to 1/e", "Yost et al. (2023), Fig. 9"),
           20.0, 120.0}}};
}

}  // namespace cpt::solver

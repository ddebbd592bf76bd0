#include "solver/mechanisms/density_lens.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism density_lens_mechanism() {
  return {.name = "density_lens",
          .title = "a looser or denser lens in the sand",
          .equation = "D_r(z) = D_r + change over |z - centre| < thickness / 2",
          .source = "range: scatter of pluviated chamber samples",
          .signature = "q_c is lower or higher over the lens and about three cone diameters to either side.",
          .acts_on = norsand_only,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::density_lens, &DensityLens::change>(
                              "density_lens.change_percent", "ΔDᵣ,lens", percent, -80.0, 80.0, norsand_only,
                              "change of the relative density in the lens", "scatter of pluviated samples"),
                          -25.0, 25.0},
                         {number<&Setup::mechanisms, &Mechanisms::density_lens, &DensityLens::centre>(
                              "density_lens.centre_mm", "z_lens", millimetres, 0.0, 10000.0, norsand_only,
                              "depth of the lens's middle", "anywhere in the push"),
                          60.0, 300.0, Prior::depth},
                         {number<&Setup::mechanisms, &Mechanisms::density_lens, &DensityLens::thickness>(
                              "density_lens.thickness_mm", "t_lens", millimetres, 1.0, 5000.0, norsand_only,
                              "thickness of the lens", "one lift of pluviation"),
                          30.0, 120.0}}};
}

}  // namespace cpt::solver

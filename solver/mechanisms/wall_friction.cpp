#include "solver/mechanisms/wall_friction.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism wall_friction_mechanism() {
  return {.name = "wall_friction",
          .title = "friction on the chamber wall",
          .equation = "d sigma_v / dz = gamma' - 2 mu K_0 sigma_v / R",
          .source = "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045; mu of sand on smooth steel to rough walls",
          .signature = "q_c falls behind with depth, in proportion to the stress that is lost.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::wall_friction, &WallFriction::coefficient>(
                              "wall_friction.coefficient", "μ_wall", none, 0.0, 1.0, any_soil,
                              "friction coefficient of the chamber wall that is mobilized before the push",
                              "sand on steel"),
                          0.0, 0.5}}};
}

}  // namespace cpt::solver

#include "solver/mechanisms/push_speed.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

Mechanism push_speed_mechanism() {
  return {
      .name = "push_speed",
      .title = "a push at another speed than the clay's strength is for",
      .equation = "s_u = s_u0 (1 + lambda log10(V / V_0))",
      .source =
          "Dayal & Allen, Can. Geotech. J. 12 (1975) 336; Lunne, Robertson & Powell (1997): about a tenth "
          "per tenfold speed; range: a twentieth to five times the speed, undrained throughout",
      .signature =
          "exactly another s_u in the same proportion at all depths: q_c and f_s cannot tell the two "
          "apart.",
      .acts_on = tresca_only,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::push_speed, &PushSpeed::decades>(
                          "push_speed.log10_ratio", "log₁₀ V/V₀", none, -3.0, 3.0, tresca_only,
                          "decimal logarithm of the push's speed over that for which s_u is given",
                          "Dayal & Allen (1975)"),
                      -1.3, 0.7},
                     {number<&Setup::mechanisms, &Mechanisms::push_speed, &PushSpeed::lambda>(
                          "push_speed.lambda", "λ_V", none, 0.0, 0.3, tresca_only,
                          "rise of s_u per tenfold speed", "Lunne, Robertson & Powell (1997)"),
                      0.1, 0.1}}};
}

}  // namespace cpt::solver

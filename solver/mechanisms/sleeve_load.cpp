#include "solver/mechanisms/sleeve_load.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"
#include "solver/simulate.hpp"

namespace cpt::solver {

void SleeveLoad::apply(DepthProfile& profile, const Penetrometer& penetrometer) const {
  if (!on() || profile.f_s.size() != profile.q_c.size()) return;
  const double areas = 4.0 * penetrometer.sleeve_length / penetrometer.diameter;
  for (std::size_t i = 0; i < profile.q_c.size(); ++i) {
    const double moved = share * profile.f_s[i];
    profile.q_c[i] += moved * areas;
    profile.f_s[i] -= moved;
  }
}

Mechanism sleeve_load_mechanism() {
  return {.name = "sleeve_load",
          .title = "sleeve friction that reaches the tip's load cell",
          .equation = "q_recorded = q_c + share f_s A_s / A_c, f_recorded = (1 - share) f_s",
          .source =
              "balance of forces on tip and sleeve; joints and seals: Lunne, Robertson & Powell, Cone "
              "Penetration Testing (1997), chapter 2; range: a tenth of the sleeve's force",
          .signature =
              "q_c is higher in proportion to f_s, and f_s is lower by one share of itself at all depths.",
          .acts_on = any_soil,
          .parameters = {{number<&Setup::mechanisms, &Mechanisms::sleeve_load, &SleeveLoad::share>(
                              "sleeve_load.share", "χ_sleeve", none, 0.0, 1.0, any_soil,
                              "share of the sleeve's force that the tip's load cell carries",
                              "balance of forces on tip and sleeve"),
                          0.0, 0.1}},
          .of_reading = true};
}

}  // namespace cpt::solver

#include "solver/mechanisms/grain_crushing.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

Mechanism grain_crushing_mechanism() {
  return {.name = "grain_crushing",
          .title = "grains that crush",
          .equation = "e_c = e_cs0 - lambda (p / p_a)^m - slope max(0, ln(p / pressure))",
          .source = "Russell & Khalili, Can. Geotech. J. 41 (2004) 1179",
          .signature =
              "q_c stops rising where the cone's stress reaches the crushing pressure: lower at depth and in "
              "dense sand, unchanged near the top.",
          .acts_on = norsand_only,
          .parameters = {
              {number<&Setup::mechanisms, &Mechanisms::grain_crushing, &GrainCrushing::slope>(
                   "grain_crushing.slope", "λ_cr", none, 0.0, 1.0, norsand_only,
                   "slope of the crushing branch of the critical state line in e over ln p",
                   "Russell & Khalili (2004)"),
               0.0, 0.15},
              {number<&Setup::mechanisms, &Mechanisms::grain_crushing, &GrainCrushing::pressure>(
                   "grain_crushing.pressure_kPa", "p_cr", kilopascals, 10.0, 1.0e5, norsand_only,
                   "mean stress at which crushing begins", "quartz sands from 0.3 MPa on for angular ones"),
               200.0, 1200.0}}};
}

}  // namespace cpt::solver

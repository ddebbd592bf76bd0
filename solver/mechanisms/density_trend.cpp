#include "solver/mechanisms/density_trend.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

Mechanism density_trend_mechanism() {
  return {
      .name = "density_trend",
      .title = "sand whose density changes with depth",
      .equation = "D_r(z) = D_r + difference (z - z_mid) / z_final, z_mid = z_final / 2",
      .source =
          "Rad & Tumay, Geotech. Test. J. 10 (1987) 31: density of rained sand follows the height of fall; "
          "range: a class of density either way",
      .signature = "q_c tilts about the middle of the push: lower above and higher below, or the reverse.",
      .acts_on = norsand_only,
      .parameters = {
          {number<&Setup::mechanisms, &Mechanisms::density_trend, &DensityTrend::difference>(
               "density_trend.difference_percent", "ΔDᵣ,trend", percent, -100.0, 100.0, norsand_only,
               "relative density at the push's final depth less that at the top, about the same mean",
               "height of fall of rained sand"),
           -20.0, 20.0}}};
}

}  // namespace cpt::solver

#include "solver/mechanisms/stress_ratio_trend.hpp"

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"
#include "solver/setup.hpp"

namespace cpt::solver {

Mechanism stress_ratio_trend_mechanism() {
  return {
      .name = "stress_ratio_trend",
      .title = "K_0 that changes with depth",
      .equation = "sigma_h = K_0 sigma_v (1 + change (z - z_mid) / z_final), z_mid = z_final / 2",
      .source =
          "Mayne & Kulhawy, J. Geotech. Eng. Div. ASCE 108 (1982) 851: K_0 grows with OCR^sin(phi); range: "
          "an overconsolidation ratio that doubles over the push",
      .signature =
          "in sand q_c tilts about the middle of the push, as with a trend of density; hardly in clay.",
      .acts_on = any_soil,
      .parameters = {{number<&Setup::mechanisms, &Mechanisms::stress_ratio_trend, &StressRatioTrend::change>(
                          "stress_ratio_trend.change", "ΔK₀/K₀", none, -1.5, 1.5, any_soil,
                          "share of K_0 by which that at the push's final depth exceeds that at the top, "
                          "about the same mean",
                          "Mayne & Kulhawy (1982)"),
                      -0.4, 0.4}}};
}

}  // namespace cpt::solver

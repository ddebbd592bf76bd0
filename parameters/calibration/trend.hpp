// How H depends on the state before shearing, over several tests.
#pragma once

#include <optional>
#include <vector>

#include "parameters/calibration/hardening.hpp"

namespace cpt::calibration {

/// H = H_0 + by_psi psi_0 + by_p ln(p_0 / p_a), least squares.
struct HardeningTrend {
  double H_0;        // [-]
  double by_psi;     // [-]
  double by_p;       // [-]; 0 where p_0 plays no part
  double r_squared;  // [-] share of the variance of H that the trend explains
  int tests;
};

enum class TrendIn {
  psi,       ///< psi_0 alone, the straight line of Yost et al. (2023), Fig. 7
  psi_and_p  ///< p_0 too, which the same figure shows to matter
};

/// Over the fits without a problem; nullopt unless there is one test more than coefficients and the tests
/// differ enough to tell the coefficients apart.
[[nodiscard]] std::optional<HardeningTrend> hardening_trend(const std::vector<HardeningFit>& fits,
                                                            TrendIn in);

}  // namespace cpt::calibration

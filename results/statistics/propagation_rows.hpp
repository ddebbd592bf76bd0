// What a propagation says besides its numbers for the windows, as plain data.
#pragma once

#include <array>
#include <limits>
#include <string>

#include "parameters/designs/bootstrap.hpp"

namespace cpt::results {

/// What the first `runs` of a design say.
struct ConvergenceRow {
  std::string window, quantity;  ///< mean, quantile_05, quantile_95
  int runs = 0;
  parameters::Estimate estimate;  // [kPa]
};

inline constexpr std::array<double, 5> band_quantiles = {0.05, 0.25, 0.5, 0.75, 0.95};

/// A channel at one depth [kPa]; NaN where fewer than two runs have a value.
struct DepthBandRow {
  std::string channel;  ///< its name (solver/channels.hpp)
  double depth_m = 0.0;
  int runs = 0;  ///< with a value there
  parameters::Estimate mean;
  double standard_deviation = std::numeric_limits<double>::quiet_NaN();
  /// Of band_quantiles; each with its interval by sections (parameters/designs/propagation.hpp).
  std::array<parameters::Estimate, band_quantiles.size()> quantiles;
};

}  // namespace cpt::results

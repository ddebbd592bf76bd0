// Figures of a calibration, each a complete SVG document.
#pragma once

#include <string>

#include "reports/calibration/input.hpp"

namespace cpt::reports::calibrated {

/// Density of each unknown before and after the recordings.
[[nodiscard]] std::string marginals_figure(const CalibrationReport& report);
/// Of each channel and sounding over depth: recorded, simulated and predicted; and the discrepancy beside it.
[[nodiscard]] std::string bands_figure(const CalibrationReport& report);
/// ECDF of the ranks of each unknown less the uniform one, with the 95 % simultaneous band.
[[nodiscard]] std::string ranks_figure(const RankReport& report);

}  // namespace cpt::reports::calibrated

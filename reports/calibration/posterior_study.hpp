// The posterior as rows of a new study.
#pragma once

#include <string>

#include "reports/calibration/input.hpp"

namespace cpt::reports::calibrated {

/// [design], [parameters] with the nearest distribution of each input (which and how near is said beside it),
/// and [correlation], in TOML, to be pasted into a study in place of its own.
[[nodiscard]] std::string posterior_study(const CalibrationReport& report);

}  // namespace cpt::reports::calibrated

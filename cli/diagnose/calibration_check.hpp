// campaign calibrate --check: simulation-based calibration with runs of the study's own design.
#pragma once

#include "cli/diagnose/calibration_file.hpp"

namespace cpt::cli {

/// Holds `count` runs out, calibrates with each as recordings on so many threads, writes and tells the ranks
/// of the truths. Returns the exit code.
[[nodiscard]] int check_calibration(const CalibrationFile& asked, int count, int threads);

}  // namespace cpt::cli

// A calibration as files.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/calibration/input.hpp"

namespace cpt::reports::calibrated {

/// posterior.csv, draws.csv, correlation.csv, bands.csv, posterior.toml, and the figures marginals and bands
/// as SVG and PNG; returns them. Throws results::Error where a file cannot be written.
std::vector<std::filesystem::path> write_calibration(const CalibrationReport& report,
                                                     const std::filesystem::path& folder);

/// uniformity.csv, ranks.csv and the figure ranks.
std::vector<std::filesystem::path> write_rank_check(const RankReport& report,
                                                    const std::filesystem::path& folder);

}  // namespace cpt::reports::calibrated

// A calibration and its check in words; every statement follows from the numbers of the report.
#pragma once

#include <string>
#include <vector>

#include "reports/calibration/input.hpp"

namespace cpt::reports::calibrated {

/// What is learnt of each input, where the discrepancy is not zero, and whether the sampler got there.
[[nodiscard]] std::vector<std::string> calibration_sentences(const CalibrationReport& report);

/// Depths [m] where 90 % of a channel's discrepancy in a sounding are on one side of zero, from the top of
/// the first cell to the bottom of the last of each run of such cells with one sign.
struct ApartDepths {
  double from, to, mean_percent;
};
[[nodiscard]] std::vector<ApartDepths> apart_depths(const std::vector<diagnosis::CalibratedBand>& bands,
                                                    int sounding);

/// Whether the ranks look uniform, and where they do not.
[[nodiscard]] std::vector<std::string> rank_sentences(const RankReport& report);

}  // namespace cpt::reports::calibrated

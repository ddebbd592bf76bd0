// What to measure next where a diagnosis does not tell its mechanisms apart.
#pragma once

#include <string>
#include <vector>

#include "cli/diagnose/request_file.hpp"
#include "cli/run/study_runner.hpp"
#include "diagnosis/diagnose.hpp"

namespace cpt::cli {

/// The sleeve friction of the same pushes, from the runs at hand, and the request's candidates, whose runs
/// are made now; ranked, the best first. Nothing where the answer's set has fewer than two mechanisms. What
/// cannot be compared is told in `remarks`.
[[nodiscard]] std::vector<diagnosis::NextMeasurement> next_measurements_of(
    StudyRunner& runner, const RequestFile& asked, const std::vector<diagnosis::SoundingData>& soundings,
    const diagnosis::Assembled& assembled, const diagnosis::Diagnosis& diagnosis,
    std::vector<std::string>& remarks);

}  // namespace cpt::cli

// What the report of a diagnosis needs, gathered from the request, the campaigns and the answer.
#pragma once

#include "diagnosis/assemble.hpp"
#include "reports/diagnosis/input.hpp"

namespace cpt::cli {

/// `fitted` (one a sounding, in order) hold the runs of fitted_study.
[[nodiscard]] reports::diagnosed::DiagnosisInput diagnosis_input(
    const diagnosis::Request& request, const std::vector<diagnosis::SoundingData>& soundings,
    const diagnosis::Assembled& assembled, const diagnosis::Options& options,
    const diagnosis::Diagnosis& diagnosis, const std::vector<results::Snapshot>& fitted);

}  // namespace cpt::cli

// The report of a diagnosis: page, numbers and figures.
#pragma once

#include <filesystem>
#include <vector>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// Writes into `folder` (made if missing; files of an earlier report are replaced):
///   NAME-diagnosis.md          the answer in plain sentences, figures, tables
///   diagnosis.json             all numbers
///   diagnosis-*.svg/.png       q_c over depth, residuals, probabilities, isolability, posterior
/// In NAME all but letters, digits, '-', '_' and '.' becomes '_'. Figures without content are left out.
/// Returns the files written, the page first. Throws std::invalid_argument if the input's parts do not
/// belong together, results::Error if a file cannot be written.
std::vector<std::filesystem::path> write_diagnosis_report(const DiagnosisInput& input,
                                                          const std::filesystem::path& folder);

}  // namespace cpt::reports::diagnosed

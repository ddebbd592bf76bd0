// The tables of a diagnosis's page, in Markdown with a heading each; "" where there is nothing to list.
#pragma once

#include <string>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

[[nodiscard]] std::string hypotheses_table(const DiagnosisInput& input);
[[nodiscard]] std::string intervals_table(const DiagnosisInput& input);
/// Of all mechanisms, with what to expect of each.
[[nodiscard]] std::string fitted_parameters_table(const DiagnosisInput& input);
[[nodiscard]] std::string before_and_after_table(const DiagnosisInput& input);
[[nodiscard]] std::string checks_table(const DiagnosisInput& input);
[[nodiscard]] std::string pairs_table(const DiagnosisInput& input);
[[nodiscard]] std::string next_measurements_table(const DiagnosisInput& input);
[[nodiscard]] std::string prior_widths_table(const DiagnosisInput& input);
[[nodiscard]] std::string study_parameters_table(const DiagnosisInput& input);
[[nodiscard]] std::string noise_table(const DiagnosisInput& input);
[[nodiscard]] std::string provenance_table(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

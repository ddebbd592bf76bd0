// Single statements of the answer. Plain text, each ending in a full stop; "" where there is nothing to say.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// So many intervals, parameters or explanations are named; of more, the number is told.
inline constexpr std::size_t most_told = 3;

/// Depths, sign, size and significance of the mismatch: recorded over refitted, as the figures show.
[[nodiscard]] std::string where_it_differs(const DiagnosisInput& input);
/// "ΔDr = 14 ± 3 % (meaning) and ℓ = 60 ± 10 mm (meaning)" of a mechanism, without full stop.
[[nodiscard]] std::string fitted_parameters(const DiagnosisInput& input, std::size_t mechanism);
/// Parameters hardly told by the recording.
[[nodiscard]] std::string weak_parameters(const DiagnosisInput& input, std::size_t mechanism);
/// Parameters whose best value lies at an end of their range.
[[nodiscard]] std::string at_ends(const DiagnosisInput& input, std::size_t mechanism);
/// Result of the winner's predictive check.
[[nodiscard]] std::string check_passed(const DiagnosisInput& input);
/// Which study parameters the null moved, and how.
[[nodiscard]] std::string parameters_moved(const DiagnosisInput& input);
/// Error of the baseline and of the recalibrated null.
[[nodiscard]] std::string recalibration_error(const DiagnosisInput& input);
/// Held-out error and gain of the best mechanism.
[[nodiscard]] std::string held_out(const DiagnosisInput& input);
/// Whether the full solver confirms the emulated fit.
[[nodiscard]] std::string solver_confirms(const DiagnosisInput& input);
/// The pair of mechanisms with the greatest evidence, as a hint.
[[nodiscard]] std::string best_pair(const DiagnosisInput& input);
/// What to measure next.
[[nodiscard]] std::string next_measurement(const DiagnosisInput& input);
/// What must be known beside the headline: a best effect that makes the fit worse, parameters at a bound,
/// what is not ruled out. Empty where the headline says it all.
[[nodiscard]] std::vector<std::string> reservations(const DiagnosisInput& input);
/// One explanation, without reservations: only this is drawn as a full bar.
[[nodiscard]] bool stands_alone(const DiagnosisInput& input);
/// Whether other prior widths change the answer.
[[nodiscard]] std::string prior_widths(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

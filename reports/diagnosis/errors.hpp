// How far the curves lie from the recording, in the cells of the diagnosis.
#pragma once

#include <optional>

#include "diagnosis/departure.hpp"
#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// Recorded over simulated q_c, less one, in each cell [%].
[[nodiscard]] VectorXd percent_above(const VectorXd& recorded, const VectorXd& simulated);

/// How far the recording lies from the study's refitted simulation on an interval: the mean of what the
/// figures draw there. Sentences, shades and tables all ask this.
[[nodiscard]] diagnosis::Departure departure(const DiagnosisInput& input,
                                             const diagnosis::Mismatch& interval);

/// Root of the mean square difference [ln q_c] over the cells where both are finite; NaN without any.
[[nodiscard]] double rmse(const VectorXd& a, const VectorXd& b);

/// The solver's runs of the fitted mechanism on the cells [ln q_c], NaN where a sounding has none; nothing
/// if no sounding has one.
[[nodiscard]] std::optional<VectorXd> solver_in_cells(const DiagnosisInput& input);

/// Standard deviation of the noise in each cell [ln q_c]: measurement and numerical, without the response
/// surface's error.
[[nodiscard]] VectorXd noise_deviation(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

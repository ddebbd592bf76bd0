// The figures of a diagnosis, each a complete SVG document; nullopt where there is nothing to draw.
#pragma once

#include <optional>
#include <string>

#include "diagnosis/answer_store.hpp"
#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// q_c over depth, one panel a sounding: recording, baseline, recalibrated null, with the best mechanism
/// (emulated, and from the solver), the mismatch intervals shaded.
[[nodiscard]] std::string profile_figure(const DiagnosisInput& input);

/// Recorded over simulated q_c [%] over depth, before and after the best mechanism.
[[nodiscard]] std::string residual_figure(const DiagnosisInput& input);

/// Probability of every hypothesis as a bar, its prior as a tick.
[[nodiscard]] std::string probability_figure(const DiagnosisInput& input);
/// The same of an answer that was stored, for the campaign's page.
[[nodiscard]] std::optional<std::string> probability_figure(const diagnosis::StoredAnswer& answer);

/// D_ij as a table of coloured cells; those below the threshold are framed.
[[nodiscard]] std::optional<std::string> isolability_figure(const DiagnosisInput& input);

/// Posterior of the best mechanism's parameters over their prior ranges.
[[nodiscard]] std::optional<std::string> posterior_figure(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

// The answer as solver runs: the study recalibrated without and with the mechanisms that may be the answer.
#pragma once

#include <string>

#include "diagnosis/assemble.hpp"

namespace cpt::diagnosis {

/// Names of the points of a fitted study: without any mechanism, and with one.
inline constexpr const char* recalibrated_point = "recalibrated";
[[nodiscard]] std::string fitted_point(const std::string& mechanism);

/// The mechanisms to run, the most probable first, at most `most`: those of the answer's set; none where the
/// answer is that nothing is missing.
[[nodiscard]] std::vector<std::size_t> finalists(const Diagnosis& diagnosis, int most);

/// The sounding's study without its design: the baseline, the study's parameters at their best without any
/// mechanism, and at their best beside each finalist, with that at its most probable values. With
/// Request::confirm 0 only the baseline. Its database is the diagnosis' own, NAME.sqlite; NAME-2.sqlite for
/// the second sounding, and so on.
[[nodiscard]] parameters::Study fitted_study(const Request& request, const SoundingStudy& sounding,
                                             std::size_t index, const Assembled& assembled,
                                             const Diagnosis& diagnosis);

}  // namespace cpt::diagnosis

// The answer as solver runs: the study recalibrated without and with the fitted mechanism.
#pragma once

#include <optional>

#include "diagnosis/design.hpp"
#include "diagnosis/diagnose.hpp"

namespace cpt::diagnosis {

/// Names of the points of a fitted study.
inline constexpr const char* recalibrated_point = "recalibrated";
inline constexpr const char* fitted_point = "fitted";

/// The sounding's study without its design: the baseline, the study's parameters at their best without any
/// mechanism, and at their best beside the most probable mechanism, with that at its most probable values (no
/// such point where there is no mechanism). Its database is the diagnosis' own, NAME.sqlite; NAME-2.sqlite
/// for the second sounding, and so on.
[[nodiscard]] parameters::Study fitted_study(const Request& request, const SoundingStudy& sounding,
                                             std::size_t index,
                                             const std::vector<MechanismDesign>& mechanisms,
                                             const Problem& problem, const Diagnosis& diagnosis);

}  // namespace cpt::diagnosis

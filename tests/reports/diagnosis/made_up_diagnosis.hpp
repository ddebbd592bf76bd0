// Diagnoses made by hand: sand compacted near the surface, told from a lens and a datum, and what else a
// diagnosis may say. No solver and no statistics behind them.
#pragma once

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

/// One mechanism explains the recording; `soundings` of 40 cells each.
[[nodiscard]] DiagnosisInput named_case(int soundings = 1);
/// The null fits, and the first parameter moved.
[[nodiscard]] DiagnosisInput nothing_missing_case();
/// "None of these" is the most probable.
[[nodiscard]] DiagnosisInput none_of_these_case();
/// The most probable mechanism fails the predictive check.
[[nodiscard]] DiagnosisInput gate_failed_case();
/// Two mechanisms are in the set of answers, and a second push would tell them apart.
[[nodiscard]] DiagnosisInput indistinguishable_case();

}  // namespace cpt::reports::diagnosed

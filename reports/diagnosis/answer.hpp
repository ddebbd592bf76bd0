// The diagnosis in plain sentences, as a geotechnical engineer would say them.
#pragma once

#include <string>
#include <vector>

#include "reports/diagnosis/input.hpp"

namespace cpt::reports::diagnosed {

enum class AnswerKind {
  named,              ///< one mechanism
  indistinguishable,  ///< several mechanisms, which the recording does not tell apart
  nothing_missing,    ///< parameters within their bounds, and noise, are enough
  none_of_these,      ///< something outside the catalogue
  gate_failed         ///< the most probable could not have made this recording
};

/// "named", "indistinguishable", ...
[[nodiscard]] const char* name_of(AnswerKind kind);

/// Plain text, not escaped.
struct Answer {
  AnswerKind kind;
  std::string headline;
  std::vector<std::string> reservations;  ///< to be read with the headline
  std::vector<std::string> paragraphs;    ///< where, what, how well it is proved, what it depends on
};

/// Wants an input that check() accepts.
[[nodiscard]] Answer answer_of(const DiagnosisInput& input);

}  // namespace cpt::reports::diagnosed

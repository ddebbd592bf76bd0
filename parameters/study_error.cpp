#include "parameters/study_error.hpp"

#include <fmt/format.h>

namespace cpt::parameters {

std::string format(std::span<const StudyError> errors) {
  std::string text;
  for (const StudyError& error : errors) {
    text += error.file;
    if (error.line > 0) text += fmt::format(":{}:{}", error.line, error.column);
    text += ": error: ";
    if (!error.key.empty()) text += error.key + ": ";
    text += error.message + "\n";
    if (!error.hint.empty()) text += fmt::format("    hint: {}\n", error.hint);
  }
  text += fmt::format("{} error{}\n", errors.size(), errors.size() == 1 ? "" : "s");
  return text;
}

}  // namespace cpt::parameters

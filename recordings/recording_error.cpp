#include "recordings/recording_error.hpp"

#include <fmt/format.h>

namespace cpt::recordings {

std::string format(const std::vector<RecordingError>& errors) {
  std::string text;
  for (const RecordingError& error : errors) {
    if (!text.empty()) text += '\n';
    text += error.file;
    if (error.line > 0) text += fmt::format(":{}:{}", error.line, error.column);
    text += fmt::format(": error: found {}, expected {}", error.found, error.expected);
    if (!error.hint.empty()) text += fmt::format("\n    hint: {}", error.hint);
  }
  return text;
}

void Problems::add(int line, int column, std::string found, std::string expected, std::string hint) {
  if (!full())
    errors_.push_back({file_, line, column, std::move(found), std::move(expected), std::move(hint)});
}

}  // namespace cpt::recordings

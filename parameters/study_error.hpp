// What is wrong with a study file, where, and what to write instead.
#pragma once

#include <span>
#include <string>

namespace cpt::parameters {

struct StudyError {
  std::string file;
  int line = 0;         ///< from 1; 0 where the file as a whole is meant
  int column = 0;       ///< from 1; 0 where the file as a whole is meant
  std::string key;      ///< full dotted key, e.g. "parameters.sand.H.upper"; "" for the file as a whole
  std::string message;  ///< value and violated constraint, with its valid range
  std::string hint;     ///< nearest valid key, likely unit, what to add; "" if there is nothing to suggest
};

/// For the terminal: "file:line:column: error: key: message" with an indented hint, then a count.
[[nodiscard]] std::string format(std::span<const StudyError> errors);

}  // namespace cpt::parameters

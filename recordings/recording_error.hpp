// What is wrong with a file, where, and what was expected instead.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cpt::recordings {

struct RecordingError {
  std::string file;
  int line = 0;          ///< from 1; 0 where the file as a whole is meant
  int column = 0;        ///< from 1, in characters; 0 where the file as a whole is meant
  std::string found;     ///< the text in quotes, or what is missing
  std::string expected;  ///< with unit or valid range
  std::string hint;      ///< what to do about it; "" if there is nothing to suggest
};

/// "a.gef:60:12: error: found 'x', expected a number" with an indented hint, one after the other.
[[nodiscard]] std::string format(const std::vector<RecordingError>& errors);

/// Errors of one file as they are found.
class Problems {
 public:
  static constexpr std::size_t at_most = 20;  ///< told at once

  explicit Problems(std::string file) : file_(std::move(file)) {}
  void add(int line, int column, std::string found, std::string expected, std::string hint = {});
  [[nodiscard]] bool any() const { return !errors_.empty(); }
  [[nodiscard]] bool full() const { return errors_.size() >= at_most; }
  [[nodiscard]] const std::vector<RecordingError>& errors() const { return errors_; }

 private:
  std::string file_;
  std::vector<RecordingError> errors_;
};

}  // namespace cpt::recordings

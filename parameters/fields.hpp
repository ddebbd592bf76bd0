// Typed fields of a study's tables; whatever is wrong with one goes on the list of errors.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parameters/document.hpp"
#include "parameters/study_error.hpp"

namespace cpt::parameters {

/// Errors after which a table is read no further.
inline constexpr std::size_t most_errors = 20;

/// Collects the errors of one file.
class ErrorList {
 public:
  explicit ErrorList(std::string file) : file_(std::move(file)) {}
  void add(Place place, std::string key, std::string message, std::string hint = "");
  [[nodiscard]] bool empty() const { return errors_.empty(); }
  [[nodiscard]] std::size_t size() const { return errors_.size(); }
  /// That an unknown key of the table is told to mean this one, which therefore is not told to be missing.
  void note_meant(const Value& table, std::string_view key) { meant_.emplace(table.place, key); }
  [[nodiscard]] bool is_meant(const Value& table, std::string_view key) const {
    return meant_.contains({table.place, std::string(key)});
  }
  /// The errors in the order of the file.
  [[nodiscard]] std::vector<StudyError> sorted() const;

 private:
  std::string file_;
  std::vector<StudyError> errors_;
  std::set<std::pair<Place, std::string>> meant_;
};

/// "a.b", or "b" if there is no a.
[[nodiscard]] std::string joined(std::string_view prefix, std::string_view key);
/// "a, b, c"
[[nodiscard]] std::string listed(std::span<const std::string_view> names);

/// An error for each key of the table that is not among the known ones, with the hint where none of these is
/// near; true if there is none.
bool refuse_unknown_keys(const Value& table, std::string_view prefix, std::span<const std::string_view> known,
                         ErrorList& errors, std::string_view hint = "");

// Each gives nothing after an error, or if `required` is false and the field is not there.
[[nodiscard]] std::optional<double> number_field(const Value& table, std::string_view prefix,
                                                 std::string_view key, bool required, ErrorList& errors);
[[nodiscard]] std::optional<bool> flag_field(const Value& table, std::string_view prefix,
                                             std::string_view key, ErrorList& errors);
[[nodiscard]] std::optional<std::string> text_field(const Value& table, std::string_view prefix,
                                                    std::string_view key, bool required, ErrorList& errors);
/// The text is one of the names.
[[nodiscard]] std::optional<std::string> name_field(const Value& table, std::string_view prefix,
                                                    std::string_view key, bool required,
                                                    std::span<const std::string_view> names,
                                                    ErrorList& errors);
/// The section [key] of the root, nullptr if it is not there or not a table.
[[nodiscard]] const Value* section(const Value& root, std::string_view key, ErrorList& errors);
/// The tables [[key]] of the root; entries that are not tables are errors.
[[nodiscard]] std::vector<const Value*> sections(const Value& root, std::string_view key, ErrorList& errors);

/// The value is a finite number.
[[nodiscard]] std::optional<double> finite_number(const Value& value, const std::string& key,
                                                  ErrorList& errors);

}  // namespace cpt::parameters

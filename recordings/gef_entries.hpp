// The header of a GEF file as entries "#KEY= value, value". Long ones go on in lines without '#'.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "recordings/recording_error.hpp"
#include "recordings/text.hpp"

namespace cpt::recordings {

class GefEntry {
 public:
  explicit GefEntry(const Line& line);
  void go_on(const Line& line);

  [[nodiscard]] std::string key() const;  ///< in lower case
  [[nodiscard]] std::string_view value() const;
  /// The value's pieces between commas.
  [[nodiscard]] std::vector<Field> fields() const { return split(value(), ','); }
  [[nodiscard]] int line() const { return parts_.front().number; }
  /// The lines it was joined from.
  [[nodiscard]] const std::vector<Line>& lines() const { return parts_; }
  struct Place {
    int line, column;
  };
  /// Of a part of the text.
  [[nodiscard]] Place place_of(std::string_view part) const;
  /// Adds an error at a part of the text, which it shows.
  void problem(std::string_view at, std::string expected, std::string hint, Problems& problems) const;

 private:
  int before_;        // characters of the first line up to its '#'
  std::string text_;  // behind the '#', lines joined by a blank
  std::vector<Line> parts_;
  std::vector<std::size_t> begins_;  // of each part in the text
};

struct GefEntries {
  std::vector<GefEntry> entries;
  std::size_t data = 0;  ///< index of the first line behind the header
};

/// Everything up to #EOH=; a problem where the header does not end.
[[nodiscard]] GefEntries read_gef_entries(const std::vector<Line>& lines, Problems& problems);

/// The fields again, with those joined that a decimal comma has cut: "0,80" among fields that a comma and a
/// blank set apart.
[[nodiscard]] std::vector<Field> with_decimal_commas(const std::vector<Field>& fields);
/// Whether a field and the next look like one number that a decimal comma has cut: "0,80", not "0, 80".
[[nodiscard]] bool cut_number(const std::vector<Field>& fields, std::size_t at);
[[nodiscard]] std::string_view joined(const Field& first, const Field& last);

}  // namespace cpt::recordings

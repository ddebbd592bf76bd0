// Text of recording files: lines, fields with their place, numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cpt::recordings {

struct Line {
  int number;  ///< from 1
  std::string_view text;
};

/// A piece of a line without blanks around it.
struct Field {
  std::string_view text;
  int column;  ///< of its first character in the line, from 1
};

struct Decoded {
  std::string text;  ///< valid UTF-8 without byte order mark
  int replaced = 0;  ///< bytes that were no UTF-8 and were read as Latin-1
};
[[nodiscard]] Decoded decoded(std::string_view bytes);

/// Ends may be LF, CR LF or CR.
[[nodiscard]] std::vector<Line> lines_of(std::string_view text);
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// Place of a part of `line` in characters, from 1.
[[nodiscard]] int column_of(std::string_view line, std::string_view part);
/// All pieces between separators, empty ones too. A blank as separator stands for any run of blanks and tabs,
/// and then there are no empty pieces.
[[nodiscard]] std::vector<Field> split(std::string_view line, char separator);

/// A whole text that is a finite number within +-1e15; nothing else ("nan", "1,5", "0x1", "") is one. A plus
/// sign may lead.
[[nodiscard]] std::optional<double> number(std::string_view text);
[[nodiscard]] std::optional<int> whole_number(std::string_view text, int min, int max);
/// 'text' for messages: shortened, unprintable characters as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);
[[nodiscard]] std::string lower_case(std::string_view text);
/// Why a text that should be a number is none, as far as that can be guessed; "" if not.
[[nodiscard]] std::string number_hint(std::string_view text);

}  // namespace cpt::recordings

// Text of recording files: lines, fields with their place, numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/recording.hpp"

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

/// Why bytes are no text, and where.
struct NoText {
  int line, column;  ///< from 1
  std::string found, expected, hint;
};

struct Decoded {
  std::string text;     ///< valid UTF-8 without byte order mark, zero bytes and end-of-file mark
  bool utf_16 = false;  ///< the file was UTF-16
  int replaced = 0;  ///< bytes that were no UTF-8 and were read as windows-1252, U+FFFD where it has nothing
  bool end_mark = false;          ///< 0x1A (Ctrl-Z) stood behind the text
  int padding = 0;                ///< bytes 0x00 and 0xFF behind the text
  Lines padded_lines;             ///< zero bytes stood at the ends of these
  std::optional<NoText> problem;  ///< there is then no text
};
/// Bytes of a file as text: UTF-8, UTF-16, else windows-1252. What old systems put behind the end is left
/// out; a mark or zero bytes amid the text are a problem, since nobody knows what they replace.
[[nodiscard]] Decoded decoded(std::string_view bytes);

/// Ends may be LF, CR LF or CR.
[[nodiscard]] std::vector<Line> lines_of(std::string_view text);
[[nodiscard]] inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// Place of a part of `line` in characters, from 1.
[[nodiscard]] int column_of(std::string_view line, std::string_view part);
/// All pieces between separators, empty ones too. A blank as separator stands for any run of blanks and tabs,
/// and then there are no empty pieces.
[[nodiscard]] std::vector<Field> split(std::string_view line, char separator);

/// A whole text that is a finite number within +-1e15; nothing else ("nan", "1,5", "0x1", "") is one. A plus
/// sign may lead, a minus may be U+2212, an exponent may follow a D as in Fortran.
[[nodiscard]] std::optional<double> number(std::string_view text);
/// The same without limits, as programs write "nothing here": 1e30, 3.4028235e38; +-infinity beyond a double.
[[nodiscard]] std::optional<double> number_of_any_size(std::string_view text);
/// Whether a value is the one that a file declares as void, up to the digits that a float loses.
[[nodiscard]] bool same_void(double value, double declared);
[[nodiscard]] std::optional<int> whole_number(std::string_view text, int min, int max);
/// 'text' for messages: shortened, unprintable characters as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);
[[nodiscard]] std::string lower_case(std::string_view text);
/// Why a text that should be a number is none, as far as that can be guessed; "" if not.
[[nodiscard]] std::string number_hint(std::string_view text);

}  // namespace cpt::recordings

// Text of figures and pages: escaping, subscripts, width and numbers as they are printed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cpt::drawing {

/// Text made safe for XML and HTML content and attributes; bytes that are not UTF-8 or not allowed become
/// U+FFFD.
[[nodiscard]] std::string escape(std::string_view text);

/// A run of text on or below the line.
struct Span {
  std::string text;
  bool subscript = false;
  bool operator==(const Span&) const = default;
};
using Rich = std::vector<Span>;

/// Text as it stands, for names that users choose.
[[nodiscard]] Rich plain(std::string_view text);
/// Text with subscripts: after '_' up to a space, slash, bracket or "=", and Unicode's subscript letters and
/// digits.
[[nodiscard]] Rich symbolic(std::string_view text);
[[nodiscard]] Rich operator+(Rich left, const Rich& right);
/// Its letters alone.
[[nodiscard]] std::string words_of(const Rich& text);
/// "<sub>" markup for pages.
[[nodiscard]] std::string html(const Rich& text);

inline constexpr double subscript_size = 0.72;  ///< of the font size
inline constexpr double subscript_drop = 0.22;  ///< of the font size
inline constexpr std::string_view font_family = "DejaVu Sans, Verdana, Arial, sans-serif";

/// Width on paper, in the unit of `font_size`.
[[nodiscard]] double width(const Rich& text, double font_size, bool bold = false);

/// A number to so many significant digits, without exponent for ordinary sizes, with a true minus sign; "–"
/// for NaN.
[[nodiscard]] std::string number(double value, int digits);
/// A number with so many decimals and a true minus sign; "–" for NaN.
[[nodiscard]] std::string decimals(double value, int digits);

}  // namespace cpt::drawing

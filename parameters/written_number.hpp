// Numbers as tables and command lines have them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cpt::parameters {

/// The whole text is one number: digits with a decimal point, at most one sign before them, which may also be
/// the minus of typeset text (U+2212), and an exponent behind e, E or the D of Fortran. "nan" and "inf" are
/// numbers too. Anything else is none: no part of a text is ever taken for the whole.
[[nodiscard]] std::optional<double> written_number(std::string_view text);

/// What is wrong with a text that is nearly a number: "decimals follow a point, not a comma: 0.5"; "" if it
/// is not near one.
[[nodiscard]] std::string number_hint(std::string_view text);

/// Without what old systems and programs put behind the end: marks of end-of-file (0x1A) and padding by zero
/// bytes.
[[nodiscard]] std::string_view without_padding(std::string_view bytes);

}  // namespace cpt::parameters

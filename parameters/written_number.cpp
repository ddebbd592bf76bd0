#include "parameters/written_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace cpt::parameters {
namespace {

constexpr std::string_view typeset_minus = "\xE2\x88\x92";  // U+2212

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<double> plain(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// With each of these marks taken out; empty where there is none.
std::string without(std::string_view text, std::string_view mark) {
  std::string left;
  bool any = false;
  while (!text.empty()) {
    if (text.starts_with(mark)) {
      any = true;
      text.remove_prefix(mark.size());
      continue;
    }
    left += text.front();
    text.remove_prefix(1);
  }
  return any ? left : "";
}

// "1,234,567.8" and "1 234": groups of three digits.
std::string thousands_hint(std::string_view text) {
  constexpr std::array<std::string_view, 6> marks = {",", " ", "'", "_", "\xC2\xA0", "\xE2\x80\xAF"};
  for (const std::string_view mark : marks) {
    const std::size_t last = text.rfind(mark), first = text.find(mark);
    const bool grouped =
        last != text.npos && last + mark.size() + 3 <= text.size() &&
        std::all_of(text.begin() + static_cast<std::ptrdiff_t>(last + mark.size()),
                    text.begin() + static_cast<std::ptrdiff_t>(last + mark.size()) + 3, is_digit);
    const bool one_comma = mark == "," && first == last && text.find('.') == text.npos;  // 1,234 may be 1.234
    if (const std::string joined = without(text, mark); grouped && !one_comma && written_number(joined))
      return fmt::format("thousands are not set apart: {}", joined);
  }
  return "";
}

std::string comma_hint(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos || text.find(',', comma + 1) != text.npos) return "";
  std::string pointed(text);
  std::erase(pointed, '.');  // of thousands: 1.234,5
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return written_number(pointed) ? fmt::format("decimals follow a point, not a comma: {}", pointed) : "";
}

// "25 kPa", "25%": a number with more behind it.
std::string unit_hint(std::string_view text) {
  for (std::size_t size = text.size() - 1; size > 0; --size) {
    const std::string_view head = text.substr(0, size), tail = text.substr(size);
    if (!is_digit(head.back()) || is_digit(tail.front()) || !written_number(head)) continue;
    const std::size_t word = tail.find_first_not_of(' ');
    const bool unit = word != tail.npos && tail.find_first_of("0123456789.,") > word && tail[word] != '+' &&
                      tail[word] != '-';
    return unit ? fmt::format("the number alone, without a unit: {}", head) : "";
  }
  return "";
}

}  // namespace

std::optional<double> written_number(std::string_view text) {
  std::string_view digits = text;
  bool negative = false;
  if (digits.starts_with('+') || digits.starts_with('-')) {
    negative = digits.front() == '-';
    digits.remove_prefix(1);
  } else if (digits.starts_with(typeset_minus)) {
    negative = true;
    digits.remove_prefix(typeset_minus.size());
  }
  if (digits.empty() || digits.front() == '-' || digits.front() == '+') return std::nullopt;
  std::string spelt(digits);
  // Fortran's 1.5D+03; "nand" and the like hold no digit before the letter.
  if (const std::size_t d = spelt.find_first_of("dD");
      d != spelt.npos && d > 0 && (is_digit(spelt[d - 1]) || spelt[d - 1] == '.'))
    spelt[d] = 'e';
  const std::optional<double> value = plain(spelt);
  return value && negative ? std::optional(-*value) : value;
}

std::string number_hint(std::string_view text) {
  constexpr std::size_t longest = 60;  // nobody means a number with more
  if (text.empty() || text.size() > longest || std::none_of(text.begin(), text.end(), is_digit)) return "";
  if (written_number(text)) return "";
  for (const auto hint : {thousands_hint, comma_hint, unit_hint})
    if (std::string said = hint(text); !said.empty()) return said;
  return "";
}

std::string_view without_padding(std::string_view bytes) {
  constexpr std::string_view padding("\0\x1A", 2);
  const std::size_t last = bytes.find_last_not_of(std::string_view("\0\x1A\r\n\t ", 6));
  const std::size_t kept = last == bytes.npos ? 0 : last + 1;
  const std::size_t mark = bytes.find_first_of(padding, kept);
  return mark == bytes.npos ? bytes : bytes.substr(0, mark);
}

}  // namespace cpt::parameters

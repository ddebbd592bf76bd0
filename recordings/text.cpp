#include "recordings/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace cpt::recordings {
namespace {

constexpr double largest = 1.0e15;

constexpr std::string_view minus = "\u2212";

/// As std::from_chars wants it.
std::string plain(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string plain;
  while (!text.empty()) {
    const bool is_minus = text.starts_with(minus);
    plain += is_minus ? '-' : text.front();
    text.remove_prefix(is_minus ? minus.size() : 1);
  }
  if (plain.find_first_of("eE") == plain.npos)
    if (const std::size_t d = plain.find_first_of("dD"); d != plain.npos) plain[d] = 'e';
  return plain;
}

}  // namespace

std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back({static_cast<int>(lines.size()) + 1, text.substr(0, end)});
    text.remove_prefix(end);
    if (text.starts_with("\r\n"))
      text.remove_prefix(2);
    else if (!text.empty())
      text.remove_prefix(1);
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

int column_of(std::string_view line, std::string_view part) {
  const auto* end = line.data() + std::clamp<std::ptrdiff_t>(part.data() - line.data(), 0,
                                                             static_cast<std::ptrdiff_t>(line.size()));
  return 1 + static_cast<int>(std::count_if(
                 line.data(), end, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::vector<Field> split(std::string_view line, char separator) {
  std::vector<Field> fields;
  const bool blanks = separator == ' ' || separator == '\t';
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(
        separator == ' ' ? line.find_first_of(" \t", from) : line.find(separator, from), line.size());
    const std::string_view piece = trimmed(line.substr(from, to - from));
    if (!(blanks && separator == ' ' && piece.empty())) fields.push_back({piece, column_of(line, piece)});
    from = to + 1;
  }
  return fields;
}

std::optional<double> number_of_any_size(std::string_view text) {
  const std::string digits = plain(text);
  const bool signed_twice = text.starts_with('+') && digits.starts_with('-');
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  if (signed_twice || first >= digits.size() || !(digits[first] == '.' || is_digit(digits[first])))
    return std::nullopt;
  double value = 0.0;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (end != last) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = digits.find_first_of("eE");
    if (exponent == digits.npos || digits[exponent + 1] == '-') return 0.0;
    return first == 1 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
  }
  if (error != std::errc{}) return std::nullopt;
  return value;
}

std::optional<double> number(std::string_view text) {
  const auto value = number_of_any_size(text);
  return value && std::abs(*value) <= largest ? value : std::nullopt;
}

bool same_void(double value, double declared) {
  return value == declared ||
         (std::isfinite(declared) && std::abs(value - declared) <= 1e-6 * std::abs(declared));
}

std::optional<int> whole_number(std::string_view text, int min, int max) {
  const auto value = number(text);
  if (!value || *value < min || *value > max || *value != std::floor(*value)) return std::nullopt;
  return static_cast<int>(*value);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string shown(text.substr(0, longest));
  if (text.size() > longest) {
    while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0x80) != 0) shown.pop_back();
    shown += "...";
  }
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; },
      '?');
  return "'" + shown + "'";
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string number_hint(std::string_view text) {
  const auto has = [&](std::string_view part) { return text.find(part) != text.npos; };
  if (number_of_any_size(text)) return "beyond 1e15: perhaps a void that is not declared";
  if ((has(",") && has(".")) || text.find(',') != text.rfind(','))
    return "write digits without separators of thousands, decimals behind a point";
  if (has(",")) return "decimals follow a point, not a comma";
  if (has(";")) return "the file does not declare ';' as its separator";
  if (has("\u2013") || has("\u2014")) return "a dash is not a minus sign";
  if (has(" ") || has("\u00A0") || has("\u202F") || has("'"))
    return "write digits without separators of thousands";
  return {};
}

}  // namespace cpt::recordings

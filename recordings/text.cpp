#include "recordings/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cpt::recordings {
namespace {

constexpr double largest = 1.0e15;

/// Length of the UTF-8 sequence that starts at `at`; 0 if there is none.
std::size_t sequence(std::string_view bytes, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || at + length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  if (length > 2) {  // neither longer than needed, nor a surrogate, nor beyond U+10FFFF
    const unsigned char second = byte(1);
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
        (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90))
      return 0;
  }
  return length;
}

}  // namespace

Decoded decoded(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  Decoded result;
  result.text.reserve(bytes.size());
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = sequence(bytes, at);
    if (length > 0) {
      result.text += bytes.substr(at, length);
      at += length;
      continue;
    }
    const auto byte = static_cast<unsigned char>(bytes[at++]);  // 0x80 to 0xFF
    result.text += static_cast<char>(0xC0 | (byte >> 6));
    result.text += static_cast<char>(0x80 | (byte & 0x3F));
    ++result.replaced;
  }
  return result;
}

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

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !(text[0] == '-' || text[0] == '.' || (text[0] >= '0' && text[0] <= '9')))
    return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (!(std::abs(value) <= largest)) return std::nullopt;
  return value;
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
  if (text.find(',') != std::string_view::npos) return "decimals follow a point, not a comma";
  if (text.find(';') != std::string_view::npos) return "the file does not declare ';' as its separator";
  return {};
}

}  // namespace cpt::recordings

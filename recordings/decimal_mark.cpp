#include "recordings/decimal_mark.hpp"

#include <algorithm>
#include <string>

#include "recordings/text.hpp"

namespace cpt::recordings {
namespace {

/// The text with a point in place of its only comma, which stands before a digit; "" if it has another form.
std::string with_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos || text.find_first_of(",.", comma + 1) != text.npos ||
      text.substr(0, comma).find('.') != text.npos || comma + 1 == text.size() || !is_digit(text[comma + 1]))
    return {};
  std::string point(text);
  point[comma] = '.';
  return point;
}

/// Whether a comma may set thousands apart: up to three digits that do not begin with 0 before it, three
/// behind.
bool may_be_thousands(std::string_view text) {
  const std::size_t comma = text.find(',');
  const std::size_t first = std::min(text.find_first_of("0123456789,"), comma);
  const std::size_t behind = text.size() - comma - 1;
  return comma > first && comma - first <= 3 && text[first] != '0' && behind == 3 &&
         std::all_of(text.begin() + static_cast<std::ptrdiff_t>(comma) + 1, text.end(), is_digit);
}

}  // namespace

std::optional<double> certain_decimal_comma(std::string_view text) {
  const std::string point = with_point(text);
  if (point.empty() || may_be_thousands(text)) return std::nullopt;
  return recordings::number(point);
}

std::optional<double> lone_number(std::string_view text) {
  const auto value = recordings::number(text);
  return value ? value : certain_decimal_comma(text);
}

void DecimalMark::hear(std::string_view text) {
  if (text.find(',') != text.npos)
    certain_ = certain_ || certain_decimal_comma(text).has_value();
  else if (!point_ && text.find('.') != text.npos)
    point_ = recordings::number_of_any_size(text).has_value();
}

std::optional<double> DecimalMark::number_of_any_size(std::string_view text) const {
  if (comma() && text.find(',') != text.npos) {
    const std::string point = with_point(text);
    return point.empty() ? std::nullopt : recordings::number_of_any_size(point);
  }
  return recordings::number_of_any_size(text);
}

std::optional<double> DecimalMark::number(std::string_view text) const {
  if (comma() && text.find(',') != text.npos) {
    const std::string point = with_point(text);
    return point.empty() ? std::nullopt : recordings::number(point);
  }
  return recordings::number(text);
}

void DecimalMark::tell(Recording& recording) const {
  if (comma())
    recording.remarks.push_back(
        {{},
         "numbers with decimal commas",
         "read as decimals",
         "no number of the file has a point, and the commas cannot set thousands apart"});
}

}  // namespace cpt::recordings

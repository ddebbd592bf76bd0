#include "recordings/clock.hpp"

#include <algorithm>
#include <chrono>

namespace cpt::recordings {

std::optional<double> seconds_of(std::string_view digits) {
  if (digits.empty() ||
      !std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }))
    return std::nullopt;
  const auto part = [&](std::size_t from, std::size_t count) {
    int value = 0;
    for (const char c : digits.substr(from, count)) value = 10 * value + (c - '0');
    return value;
  };
  if (digits.size() <= 12) {
    double milliseconds = 0.0;
    for (const char c : digits) milliseconds = 10.0 * milliseconds + (c - '0');
    return milliseconds * 1e-3;
  }
  if (digits.size() != 14 && digits.size() != 17) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(part(0, 4)),
                                         std::chrono::month(static_cast<unsigned>(part(4, 2))),
                                         std::chrono::day(static_cast<unsigned>(part(6, 2))));
  const int hour = part(8, 2), minute = part(10, 2), second = part(12, 2);
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  const double milliseconds = digits.size() == 17 ? part(14, 3) : 0;
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second + 1e-3 * milliseconds;
}

}  // namespace cpt::recordings

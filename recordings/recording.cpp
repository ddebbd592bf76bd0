#include "recordings/recording.hpp"

#include <algorithm>
#include <cmath>

namespace cpt::recordings {

std::string_view name_of(DepthRule rule) {
  switch (rule) {
    case DepthRule::stated:
      return "as the file gives it";
    case DepthRule::from_inclination:
      return "length corrected for the inclination";
    case DepthRule::length:
      break;
  }
  return "length along the rods, not corrected";
}

void Lines::add(int line) {
  first = rows == 0 ? line : std::min(first, line);
  last = std::max(last, line);
  ++rows;
}

std::vector<double> column(const Recording& recording, double Reading::*quantity) {
  std::vector<double> values;
  values.reserve(recording.readings.size());
  for (const Reading& reading : recording.readings) values.push_back(reading.*quantity);
  return values;
}

bool has(const Recording& recording, double Reading::*quantity) {
  return std::any_of(recording.readings.begin(), recording.readings.end(),
                     [&](const Reading& reading) { return !std::isnan(reading.*quantity); });
}

Spread spread(const std::vector<double>& values) {
  std::vector<double> known;
  for (const double value : values)
    if (!std::isnan(value)) known.push_back(value);
  if (known.empty()) return {};
  std::sort(known.begin(), known.end());
  const std::size_t n = known.size();
  return {static_cast<int>(n), known.front(), 0.5 * (known[(n - 1) / 2] + known[n / 2]), known.back()};
}

}  // namespace cpt::recordings

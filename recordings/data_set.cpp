#include "recordings/data_set.hpp"

#include <fmt/format.h>

#include <cmath>

#include "recordings/units.hpp"

namespace cpt::recordings {
namespace {

constexpr double largest_stress = 1.0e5 * kPa;  // [Pa]

}  // namespace

std::vector<std::string> problems(const DataSet& set) {
  std::vector<std::string> found;
  if (set.soundings.empty()) found.emplace_back("the data set has no sounding");
  for (std::size_t i = 0; i < set.soundings.size(); ++i) {
    const Sounding& s = set.soundings[i];
    const std::string who = fmt::format("sounding {} ({})", i + 1, s.recording.id);
    const auto check_stress = [&](const char* name, double value) {
      if (!(value >= 0.0 && value <= largest_stress))
        found.push_back(fmt::format("{}: {} is {:g} kPa, must be 0 to {:g} kPa", who, name, value / kPa,
                                    largest_stress / kPa));
    };
    if (s.recording.readings.empty()) found.push_back(who + ": has no readings");
    check_stress("sigma_v0", s.sigma_v0);
    check_stress("sigma_h0", s.sigma_h0);
    if (s.D_r && !(*s.D_r >= 0.0 && *s.D_r <= 1.2))
      found.push_back(fmt::format("{}: D_r is {:g} %, must be 0 to 120 %", who, *s.D_r * 100.0));
    if (!std::isfinite(s.x) || !std::isfinite(s.y)) found.push_back(who + ": has no position");
    if (s.push_order < 1)
      found.push_back(fmt::format("{}: push order is {}, must be 1 or more", who, s.push_order));
    for (std::size_t j = 0; j < i; ++j)
      if (set.soundings[j].x == s.x && set.soundings[j].y == s.y &&
          set.soundings[j].push_order == s.push_order && set.soundings.size() > 1)
        found.push_back(
            fmt::format("{}: stands where sounding {} does, with the same push order", who, j + 1));
  }
  return found;
}

}  // namespace cpt::recordings

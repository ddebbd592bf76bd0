#include "parameters/calibration/read_oedometer_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cpt::calibration {
namespace {

constexpr std::size_t fewest_stages = 3;        // readings that make a curve
constexpr double least_e = 0.05, most_e = 5.0;  // [-]
constexpr double least_kPa = 0.01, most_kPa = 1.0e6;
constexpr std::string_view stress_column = "sigma_v_kPa";

}  // namespace

OedometerOrProblems parse_oedometer_curve(std::string_view text, const std::filesystem::path& file) {
  OedometerCurve curve;
  LaboratoryFile reader(file, curve.name,
                        {{"e0", 0.1, 3.0, 1.0, &curve.e_0}, {"K0", 0.1, 3.0, 1.0, &curve.K_0}},
                        {{stress_column, true}, {"e", true}}, "sigma_v_kPa and e");
  reader.read(text, [&](std::span<const Entry> row) {
    const Entry &sigma_v = row[0], &e = row[1];
    if (sigma_v.value < least_kPa || sigma_v.value > most_kPa)
      return reader.problem(sigma_v.column, fmt::format("{} = {}: must be {} to {}", stress_column,
                                                        sigma_v.value, least_kPa, most_kPa));
    if (e.value < least_e || e.value > most_e)
      return reader.problem(e.column, fmt::format("e = {}: must be {} to {}", e.value, least_e, most_e));
    if (!curve.readings.empty() && sigma_v.value * kPa < curve.readings.back().sigma_v)
      return reader.problem(sigma_v.column,
                            fmt::format("{} = {} falls: leave out unloading", stress_column, sigma_v.value));
    curve.readings.push_back({sigma_v.value * kPa, e.value});
  });
  if (reader.problems().empty()) {
    if (curve.readings.size() < fewest_stages)
      reader.problem(0,
                     fmt::format("has {} readings; a curve needs {}", curve.readings.size(), fewest_stages));
    else if (curve.readings.front().sigma_v == curve.readings.back().sigma_v)
      reader.problem(0, "has no reading beyond its first stress");
  }
  if (!reader.problems().empty()) return reader.problems();
  return curve;
}

bool is_oedometer_curve(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto first = line.find_first_not_of(" \t\r\"\xEF\xBB\xBF");
    if (first == std::string_view::npos || line[first] == '#') continue;
    return line.find(stress_column) != std::string_view::npos;
  }
  return false;
}

}  // namespace cpt::calibration

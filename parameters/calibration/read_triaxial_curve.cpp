#include "parameters/calibration/read_triaxial_curve.hpp"

#include <fmt/format.h>

#include <cmath>

namespace cpt::calibration {
namespace {

constexpr double MPa = 1.0e6;               // [Pa]
constexpr double percent = 0.01;            // [-]
constexpr std::size_t fewest_readings = 3;  // readings that make a curve

}  // namespace

CurveOrProblems parse_triaxial_curve(std::string_view text, const std::filesystem::path& file) {
  TriaxialCurve curve;
  LaboratoryFile reader(file, curve.name,
                        {{"p0_kPa", 0.01, 1.0e5, kPa, &curve.p_0},
                         {"e0", 0.1, 3.0, 1.0, &curve.e_0},
                         {"D_r_percent", 0.0, 120.0, percent, &curve.D_r},
                         {"G0_MPa", 0.1, 1.0e4, MPa, &curve.G_0}},
                        {{"eps_a_percent", true}, {"q_kPa", true}, {"eps_v_percent", false}},
                        "eps_a_percent, q_kPa and, if measured, eps_v_percent");
  reader.read(text, [&](std::span<const Entry> row) {
    const Entry &eps_a = row[0], &q = row[1], &eps_v = row[2];
    if (std::abs(eps_v.value) >= 100.0)
      return reader.problem(eps_v.column,
                            fmt::format("eps_v_percent = {}: must be -100 to 100", eps_v.value));
    if (eps_a.value < 0.0 || eps_a.value >= 100.0)
      return reader.problem(eps_a.column, fmt::format("eps_a_percent = {}: must be 0 to 100", eps_a.value));
    if (!curve.readings.empty() && eps_a.value * percent < curve.readings.back().eps_a)
      return reader.problem(eps_a.column,
                            fmt::format("eps_a_percent = {} falls: leave out unloading", eps_a.value));
    curve.readings.push_back({eps_a.value * percent, q.value * kPa, eps_v.value * percent});
  });
  if (reader.problems().empty()) {
    if (curve.readings.size() < fewest_readings)
      reader.problem(
          0, fmt::format("has {} readings; a curve needs {}", curve.readings.size(), fewest_readings));
    if (!std::isnan(curve.e_0) && !std::isnan(curve.D_r)) reader.problem(0, "gives both e0 and D_r_percent");
  }
  if (!reader.problems().empty()) return reader.problems();
  return curve;
}

}  // namespace cpt::calibration

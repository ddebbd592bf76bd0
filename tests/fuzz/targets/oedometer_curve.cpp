#include <cmath>

#include "parameters/calibration/read_oedometer_curve.hpp"
#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

using namespace calibration;

Fate oedometer_curve(std::string_view text) {
  static_cast<void>(is_oedometer_curve(text));
  const OedometerOrProblems read = parse_oedometer_curve(text, "fuzzed.csv");
  if (const auto* problems = std::get_if<std::vector<CurveProblem>>(&read)) {
    promise(!problems->empty() && !format(*problems).empty(), "a refused curve has problems");
    return Fate::refused;
  }
  const auto& curve = std::get<OedometerCurve>(read);
  promise(curve.readings.size() >= 3, "a curve has readings");
  double stress = 0.0;
  for (const OedometerReading& reading : curve.readings) {
    promise(std::isfinite(reading.sigma_v) && reading.sigma_v > 0.0 && reading.sigma_v >= stress,
            "stress does not fall");
    promise(std::isfinite(reading.e) && reading.e > 0.0, "void ratios are positive");
    stress = reading.sigma_v;
  }
  promise(curve.readings.back().sigma_v > curve.readings.front().sigma_v, "stress rises");
  promise(!(curve.e_0 <= 0.0) && !(curve.K_0 <= 0.0), "facts are positive or absent");
  return Fate::sound;
}

}  // namespace cpt::fuzz

#include <cmath>

#include "parameters/calibration/read_triaxial_curve.hpp"
#include "tests/fuzz/targets.hpp"

namespace cpt::fuzz {

using namespace calibration;

Fate triaxial_curve(std::string_view text) {
  const CurveOrProblems read = parse_triaxial_curve(text, "fuzzed.csv");
  if (const auto* problems = std::get_if<std::vector<CurveProblem>>(&read)) {
    promise(!problems->empty() && !format(*problems).empty(), "a refused curve has problems");
    return Fate::refused;
  }
  const auto& curve = std::get<TriaxialCurve>(read);
  promise(!curve.readings.empty(), "a curve has readings");
  double strain = -1e300;
  for (const Reading& reading : curve.readings) {
    promise(std::isfinite(reading.eps_a) && reading.eps_a >= strain, "axial strain does not fall");
    promise(std::isfinite(reading.q) && !std::isinf(reading.eps_v), "readings are finite");
    strain = reading.eps_a;
  }
  return Fate::sound;
}

}  // namespace cpt::fuzz

// Reads an oedometer test from CSV.
//
//   # test = oedometer, loose       optional; other comments are free
//   # K0 = 0.45                     optional: radial over vertical stress at the first reading [0.5]
//   # e0 = 0.812                    optional: void ratio at the first reading's stress [that reading's]
//   sigma_v_kPa,e
//   10,0.812
//   20,0.808
//
// Columns, fields and other comments as in a triaxial test (read_triaxial_curve.hpp).
#pragma once

#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/calibration/laboratory_file.hpp"
#include "parameters/calibration/oedometer_curve.hpp"

namespace cpt::calibration {

/// The curve, or everything that is wrong with the file.
using OedometerOrProblems = std::variant<OedometerCurve, std::vector<CurveProblem>>;

/// From a file's text; `file` names it in messages. Never throws for what the text says.
[[nodiscard]] OedometerOrProblems parse_oedometer_curve(std::string_view text,
                                                        const std::filesystem::path& file);

/// Whether the first line that is no comment names a column sigma_v_kPa.
[[nodiscard]] bool is_oedometer_curve(std::string_view text);

}  // namespace cpt::calibration

// Reads a drained triaxial test from CSV.
//
//   # test = dense, 160 kPa          optional; other comments are free
//   # D_r_percent = 80               or e0 = 0.62; may come from the command line instead
//   # p0_kPa = 160                   may come from the command line instead
//   # G0_MPa = 85                    optional: shear modulus at small strains before shearing
//   eps_a_percent,q_kPa,eps_v_percent
//   0.00,0.0,0.00
//   0.25,212.4,0.05
//
// The first line that is no comment names the columns, in any order; eps_v_percent may be missing, and
// further columns are not read. Fields are set apart by commas, semicolons or tabs, whichever the names are.
// Strains are engineering strains, compression-positive.
#pragma once

#include <filesystem>
#include <string_view>
#include <variant>
#include <vector>

#include "parameters/calibration/laboratory_file.hpp"
#include "parameters/calibration/triaxial_curve.hpp"

namespace cpt::calibration {

/// The curve, or everything that is wrong with the file.
using CurveOrProblems = std::variant<TriaxialCurve, std::vector<CurveProblem>>;

/// From a file's text; `file` names it in messages. Never throws for what the text says.
[[nodiscard]] CurveOrProblems parse_triaxial_curve(std::string_view text, const std::filesystem::path& file);

}  // namespace cpt::calibration

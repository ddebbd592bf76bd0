// Reads a request for a calibration from TOML.
//
//   title = "Clay, first push"
//   study = "clay.toml"                  # parameters, their distributions, and the runs
//   channels = ["q_c", "f_s"]            # all that study and recordings have, if not given
//
//   [[soundings]]
//   recording = "first.csv"
//   columns = { depth_m = "z_m", q_c_MPa = "qc" }   # CSV only
//   from_m = 0.04
//   to_m = 0.14
//
//   [noise]                              # all optional
//   measurement_percent = 1.0
//   [discrepancy]
//   deviation_percent = 5
//   correlation_mm = 125
//   [options]
//   cell_mm = 5
//   chains = 4
//   seed = 1
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "diagnosis/calibration/calibration_request.hpp"
#include "parameters/study_error.hpp"

namespace cpt::diagnosis {

/// The request, or everything that is wrong with the file (never empty).
using CalibrationRequestOrErrors = std::variant<CalibrationRequest, std::vector<parameters::StudyError>>;

/// `study` is what the file's own key `study` names, read before (study_of_request). Never throws for what
/// the file says.
[[nodiscard]] CalibrationRequestOrErrors parse_calibration_request(std::string_view toml,
                                                                   const std::filesystem::path& file,
                                                                   const parameters::Study& study);

/// What is wrong with a request whatever its study holds; empty if nothing is.
[[nodiscard]] std::vector<parameters::StudyError> calibration_request_problems(
    std::string_view toml, const std::filesystem::path& file);

}  // namespace cpt::diagnosis

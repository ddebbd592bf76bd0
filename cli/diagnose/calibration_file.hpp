// A request for a calibration as a file, with its study.
#pragma once

#include <filesystem>

#include "cli/common/study_argument.hpp"
#include "diagnosis/calibration/calibrate.hpp"
#include "diagnosis/calibration/calibration_request.hpp"
#include "results/emulator/emulator.hpp"

namespace cpt::cli {

struct CalibrationFile {
  diagnosis::CalibrationRequest request;
  StudyFile study;
};

/// Recordings that are not where the request says are looked for in `recordings`, if that is not empty.
/// Throws BadInput with all that is wrong in request and study.
[[nodiscard]] CalibrationFile read_calibration_file(const std::filesystem::path& file,
                                                    const std::filesystem::path& recordings);

[[nodiscard]] diagnosis::CalibrateOptions options_of(const diagnosis::CalibrationRequest& request);

/// Whether the emulator is refused for every channel that is asked for; then it says so on stderr.
[[nodiscard]] bool refuse_all_channels(const diagnosis::CalibrationRequest& request,
                                       const results::Emulator& emulator);

}  // namespace cpt::cli

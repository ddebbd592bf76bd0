#include "cli/diagnose/calibration_file.hpp"

#include <fmt/format.h>

#include "cli/common/input_kind.hpp"
#include "cli/diagnose/request_file.hpp"
#include "diagnosis/calibration/read_calibration_request.hpp"
#include "diagnosis/read_request.hpp"

namespace cpt::cli {

using namespace diagnosis;

CalibrationFile read_calibration_file(const std::filesystem::path& file,
                                      const std::filesystem::path& recordings) {
  const std::string text = read_input(InputKind::request, file);
  const std::filesystem::path study_file = study_of_request(text, file);
  CalibrationFile asked;
  if (!study_file.empty()) {
    asked.study = study_of(study_file, calibration_request_problems(text, file));
    refuse_external(asked.study.study, "calibrate");
  }
  auto parsed = parse_calibration_request(text, file, asked.study.study);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  asked.request = std::get<CalibrationRequest>(std::move(parsed));
  look_for_recordings(asked.request.soundings, asked.request.file.parent_path(), recordings);
  return asked;
}

CalibrateOptions options_of(const CalibrationRequest& request) {
  CalibrateOptions options;
  options.chains = request.chains;
  options.sampler.seed = request.seed;
  return options;
}

bool refuse_all_channels(const CalibrationRequest& request, const results::Emulator& emulator) {
  std::string told;
  for (const solver::Channel* channel : request.channels) {
    const results::EmulatedOutput* output = emulator.output(solver::in_unit(*channel, "kPa"));
    const std::string why = output == nullptr ? "" : refusal_of(*output);
    if (why.empty()) return false;
    told += fmt::format("refused: {}: {}\n", output->name, why);
  }
  fmt::print(stderr,
             "{}no channel is left to compare; more runs may mend it: campaign emulate {} --next 10\n", told,
             request.study.string());
  return true;
}

}  // namespace cpt::cli

#include "cli/diagnose/request_file.hpp"

#include <fmt/format.h>

#include "cli/common/input_kind.hpp"
#include "diagnosis/read_request.hpp"

namespace cpt::cli {

using namespace diagnosis;

recordings::Recording recording_of(const SoundingRequest& sounding) {
  auto read = recordings::parse_recording(read_input(InputKind::recording, sounding.recording),
                                          sounding.recording, sounding.options);
  if (const auto* errors = std::get_if<std::vector<recordings::RecordingError>>(&read))
    throw BadInput(recordings::format(*errors));
  return std::get<recordings::Recording>(std::move(read));
}

void look_for_recordings(std::vector<SoundingRequest>& soundings, const std::filesystem::path& here,
                         const std::filesystem::path& elsewhere) {
  for (SoundingRequest& sounding : soundings)
    if (!elsewhere.empty() && !std::filesystem::exists(sounding.recording))
      sounding.recording = elsewhere / sounding.recording.lexically_relative(here);
}

StudyFile study_of(const std::filesystem::path& study,
                   const std::vector<parameters::StudyError>& problems_of_request) {
  try {
    return read_study_file(study);
  } catch (const BadInput& problem) {
    if (problems_of_request.empty()) throw;
    throw BadInput(fmt::format("{}{}{}", problem.what(),
                               std::string_view(problem.what()).ends_with('\n') ? "" : "\n",
                               parameters::format(problems_of_request)));
  }
}

RequestFile read_request_file(const std::filesystem::path& file, const std::filesystem::path& recordings) {
  const std::string text = read_input(InputKind::request, file);
  const std::filesystem::path study_file = study_of_request(text, file);
  RequestFile asked;
  if (!study_file.empty()) {
    StudyFile study = study_of(study_file, request_problems(text, file, Recordings::given));
    refuse_external(study.study, "diagnose");
    asked.study = std::move(study.study);
    asked.study_text = std::move(study.text);
  }
  auto parsed = parse_request(text, file, asked.study);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  asked.request = std::get<Request>(std::move(parsed));
  look_for_recordings(asked.request.soundings, asked.request.file.parent_path(), recordings);
  return asked;
}

std::vector<SoundingData> soundings_of(const RequestFile& asked) {
  std::vector<SoundingData> soundings;
  for (const SoundingRequest& sounding : asked.request.soundings) {
    soundings.push_back({sounding,
                         sounding_study(asked.study, sounding, asked.request.mechanisms,
                                        asked.request.repeats, asked.request.joint),
                         recording_of(sounding),
                         {}});
    try {
      check_recording(sounding, soundings.back().recording, asked.request.cell_height);
    } catch (const std::invalid_argument& problem) {
      throw BadInput(problem.what());
    }
  }
  return soundings;
}

}  // namespace cpt::cli

// Requests for a diagnosis as files: what they ask, their recordings, and the studies to run for them.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/common/study_argument.hpp"
#include "diagnosis/assemble.hpp"
#include "diagnosis/request.hpp"
#include "parameters/study_error.hpp"

namespace cpt::cli {

/// A request and its study, as written.
struct RequestFile {
  parameters::Study study;
  std::string study_text;
  diagnosis::Request request;
};

/// The sounding's file. Throws BadInput where it cannot be read.
[[nodiscard]] recordings::Recording recording_of(const diagnosis::SoundingRequest& sounding);

/// Recordings beside a request in the folder `here` that are not there are looked for in `elsewhere`, if that
/// is not empty.
void look_for_recordings(std::vector<diagnosis::SoundingRequest>& soundings,
                         const std::filesystem::path& here, const std::filesystem::path& elsewhere);

/// The study that a request or plan names. Throws BadInput with all that is wrong with it, and what is wrong
/// with the request itself.
[[nodiscard]] StudyFile study_of(const std::filesystem::path& study,
                                 const std::vector<parameters::StudyError>& problems_of_request);

/// Recordings that are not where the request says are looked for in `recordings`, if that is not empty.
/// Throws BadInput with all that is wrong in request and study.
[[nodiscard]] RequestFile read_request_file(const std::filesystem::path& file,
                                            const std::filesystem::path& recordings = {});

/// Its soundings with their recordings and the studies to run, not yet run. Throws BadInput for recordings
/// that cannot be read or are useless.
[[nodiscard]] std::vector<diagnosis::SoundingData> soundings_of(const RequestFile& asked);

}  // namespace cpt::cli

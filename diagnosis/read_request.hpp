// Reads a request for a diagnosis from TOML.
//
//   title = "Sand, first push"
//   study = "sens.toml"                 # its parameters and bounds; its finished realizations are used
//   mechanisms = ["surface_compaction"] # all that apply, if not given
//
//   [[soundings]]
//   name = "first"
//   recording = "first.csv"
//   columns = { depth_m = "z_m", q_c_MPa = "qc" }   # CSV only
//   from_m = 0.04
//   to_m = 0.32
//   fixed = { "initial.sigma_v0_kPa" = 100 }        # known to differ from the study's baseline
//
//   [noise]                              # all optional
//   measurement_percent = 1.0            # if not given: from the recording's own high-pass part
//   correlation_mm = 10
//   simulated = false
#pragma once

#include <variant>
#include <vector>

#include "diagnosis/request.hpp"
#include "parameters/study_error.hpp"

namespace cpt::diagnosis {

/// The request, or everything that is wrong with the file (never empty).
using RequestOrErrors = std::variant<Request, std::vector<parameters::StudyError>>;

/// Whether the soundings name their recordings, or are the plan of recordings to be made: then each has a
/// `name` instead, and the file may have a section [cases], which is read elsewhere
/// (validation/concealed/plan.hpp).
enum class Recordings { given, to_be_made };

/// `study` is what the file's own key `study` names, read before (study_of_request). Never throws for what
/// the file says.
[[nodiscard]] RequestOrErrors parse_request(std::string_view toml, const std::filesystem::path& file,
                                            const parameters::Study& study,
                                            Recordings recordings = Recordings::given);

/// What is wrong with a request whatever its study holds; empty if nothing is. For where the study cannot be
/// read.
[[nodiscard]] std::vector<parameters::StudyError> request_problems(std::string_view toml,
                                                                   const std::filesystem::path& file,
                                                                   Recordings recordings);

/// The study's path that a request names, absolute; empty if it names none or is not TOML (parse_request says
/// why).
[[nodiscard]] std::filesystem::path study_of_request(std::string_view toml,
                                                     const std::filesystem::path& file);

}  // namespace cpt::diagnosis

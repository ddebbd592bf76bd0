#include "cli/validate/plan_file.hpp"

#include "cli/common/input_kind.hpp"
#include "cli/diagnose/request_file.hpp"

namespace cpt::cli {

PlanFile read_plan_file(const std::filesystem::path& file) {
  const std::string text = read_input(InputKind::plan, file);
  PlanFile read;
  const std::filesystem::path study_file = diagnosis::study_of_request(text, file);
  if (!study_file.empty()) {
    StudyFile study =
        study_of(study_file, diagnosis::request_problems(text, file, diagnosis::Recordings::to_be_made));
    read.study = std::move(study.study);
    read.study_text = std::move(study.text);
  }
  auto parsed = validation::concealed::parse_plan(text, file, read.study);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed))
    throw BadInput(parameters::format(*errors));
  read.plan = std::get<validation::concealed::Plan>(std::move(parsed));
  return read;
}

}  // namespace cpt::cli

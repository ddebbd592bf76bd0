#include "results/ledger/model_remarks.hpp"

#include <fmt/format.h>

#include "parameters/read_study.hpp"
#include "solver/thin_layers.hpp"

namespace cpt::results {

std::vector<std::string> model_remarks(const Snapshot& campaign) {
  const auto parsed = parameters::parse_stored_study(campaign.campaign.study_text, campaign.campaign.name);
  if (const auto* study = std::get_if<parameters::Study>(&parsed))
    return solver::layer_remarks(study->baseline);
  std::vector<std::string> remarks;
  for (const parameters::StudyError& error : std::get<std::vector<parameters::StudyError>>(parsed))
    if (error.key == "layers")
      remarks.push_back(fmt::format("the layers are not what the study asks for: {}", error.message));
  return remarks;
}

}  // namespace cpt::results

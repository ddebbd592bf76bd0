#include "validation/paper/pushes.hpp"

#include <fmt/format.h>

#include "reports/labels.hpp"

namespace cpt::validation::paper {
namespace {

Push missing_push(std::string why) { return {std::nullopt, std::move(why)}; }

Push read_push(const std::filesystem::path& folder, const Studies& studies, std::string_view study,
               bool of_90_kPa) {
  const auto campaign = studies.find(study);
  if (campaign == studies.end()) return missing_push(fmt::format("{} has not been run", study));
  const results::RealizationRow* run = of_90_kPa
                                           ? reports::bound_run(campaign->second, inputs::sigma_h0, "upper")
                                           : reports::baseline_run(campaign->second);
  if (run == nullptr) return missing_push(fmt::format("{}: there is no such realization", study));
  const std::string name = run->id == 1 ? std::string(study) : fmt::format("{}-{}", study, run->id);
  const std::filesystem::path file = folder / (name + "-push") / (name + "-histories.h5");
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored))
    return missing_push(fmt::format("the push of {}, realization {}, has not been recorded", study, run->id));
  results::Histories histories = results::read_histories(file);
  if (histories.origin.at("settings_hash") != run->settings_hash)
    return missing_push(fmt::format(
        "the recorded push of {}, realization {}, has other settings than the campaign", study, run->id));
  if (histories.origin.at("status") != "completed")
    return missing_push(fmt::format("the recorded push of {}, realization {}, ended early ({})", study,
                                    run->id, histories.origin.at("status")));
  return {std::move(histories), {}};
}

}  // namespace

Pushes read_pushes(const std::filesystem::path& folder, const Studies& studies) {
  return {read_push(folder, studies, dense_rigid_study, false),
          read_push(folder, studies, dense_rigid_study, true),
          read_push(folder, studies, dense_flexible_study, false),
          read_push(folder, studies, dense_flexible_study, true)};
}

Runs read_runs(const std::filesystem::path& folder) {
  Runs runs{read_studies(folder), {}};
  runs.pushes = read_pushes(folder, runs.studies);
  return runs;
}

}  // namespace cpt::validation::paper

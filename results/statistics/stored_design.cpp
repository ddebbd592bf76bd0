#include "results/statistics/stored_design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <variant>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/read_study.hpp"
#include "results/statistics/propagation_stop.hpp"

namespace cpt::results {
namespace {

// Of each run of the design; nullptr where the ledger has another one in its place.
std::vector<const RealizationRow*> stored_runs(const parameters::Study& study, const Snapshot& s) {
  const auto realizations = parameters::all_realizations(study);
  std::map<int, const RealizationRow*> by_id;
  for (const RealizationRow& row : s.realizations) by_id[row.id] = &row;
  std::vector<const RealizationRow*> runs;
  for (const std::size_t index : parameters::design_realizations(study, realizations)) {
    const parameters::Realization& realization = realizations[index];
    const auto found = by_id.find(realization.id);
    const bool same = found != by_id.end() &&
                      found->second->parameter == parameter_name(study, realization) &&
                      found->second->side == to_string(realization.side) &&
                      found->second->value_text == value_text(study, realization);
    runs.push_back(same ? found->second : nullptr);
  }
  return runs;
}

}  // namespace

StoredDesign stored_design(const Snapshot& s) {
  StoredDesign stored;
  auto parsed = parameters::parse_stored_study(s.campaign.study_text, s.campaign.name);
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed)) {
    stored.problem =
        fmt::format("the study in the ledger cannot be read by this program: {}", errors->front().message);
    return stored;
  }
  stored.study = std::get<parameters::Study>(std::move(parsed));
  stored.runs = stored_runs(*stored.study, s);
  // The runs of a diagnosis are not those that its study's text asks for.
  if (std::ranges::all_of(stored.runs, [](const auto* run) { return run == nullptr; })) {
    stored.runs.clear();
    return stored;
  }
  stored.enough = runs_that_suffice(*stored.study, s, stored.runs);
  stored.stopped = stop_words(*stored.study, stored.enough);
  if (stored.enough) stored.runs.resize(*stored.enough);
  return stored;
}

}  // namespace cpt::results

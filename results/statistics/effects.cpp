#include "results/statistics/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <variant>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/read_study.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

// Each in its file in designs/.
void add_pairs_effects(WindowEffects& window);
void add_morris_effects(WindowEffects& window);
void add_latin_hypercube_effects(WindowEffects& window);
void add_sobol_effects(WindowEffects& window);
void add_propagation_effects(WindowEffects& window);

namespace {

using parameters::Study;

// The stored realization of each run of the design; nullptr where the ledger has another one in its place.
std::vector<const RealizationRow*> stored_runs(const Study& study, const Snapshot& s) {
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

struct Estimator {
  std::string_view design;
  void (*add)(WindowEffects& window);
};
constexpr std::array estimators = {
    Estimator{"pairs", add_pairs_effects},
    Estimator{"morris", add_morris_effects},
    Estimator{"latin_hypercube", add_latin_hypercube_effects},
    Estimator{"sobol", add_sobol_effects},
    Estimator{"propagation", add_propagation_effects},
};

}  // namespace

std::string repeats_so_far(const Snapshot& s) {
  std::size_t all = 0, waiting = 0;
  for (const RealizationRow& run : s.realizations)
    if (run.side == "repeat") ++all, waiting += run.waiting() ? 1 : 0;
  return waiting == 0 ? "" : fmt::format("{} of {} repeats so far", all - waiting, all);
}

Effects design_effects(const Snapshot& s) {
  Effects effects;
  const auto parsed = parameters::parse_study(s.campaign.study_text, s.campaign.name + ".toml");
  if (const auto* errors = std::get_if<std::vector<parameters::StudyError>>(&parsed)) {
    effects.problem =
        fmt::format("the study in the ledger cannot be read by this program: {}", errors->front().message);
    return effects;
  }
  const Study& study = std::get<Study>(parsed);
  const std::vector<const RealizationRow*> runs = stored_runs(study, s);
  // The runs of a diagnosis are not those that its study's text asks for.
  if (std::all_of(runs.begin(), runs.end(), [](const auto* run) { return run == nullptr; })) return effects;
  effects.design = study.design.kind;
  for (const RealizationRow* run : runs)
    if (run != nullptr) effects.runs.push_back(run->id);
  const auto estimator = std::ranges::find(estimators, effects.design, &Estimator::design);
  if (estimator == estimators.end()) return effects;
  for (const WindowRow& row : s.windows) {
    WindowEffects window(study, s, row, runs, effects.rows);
    estimator->add(window);
  }
  return effects;
}

Table effects_table(const Effects& effects) {
  Table table{{"window", "parameter", "other_parameter", "quantity", "unit", "value", "lower", "upper",
               "used", "dropped", "note"},
              {}};
  const auto number = [](double value) {
    return std::isfinite(value) ? Cell(value) : Cell(std::monostate{});
  };
  for (const EffectRow& row : effects.rows)
    table.rows.push_back({row.window, row.parameter, row.other_parameter, row.quantity, row.unit,
                          number(row.value), number(row.lower), number(row.upper), std::int64_t{row.used},
                          std::int64_t{row.dropped}, row.note});
  return table;
}

}  // namespace cpt::results

#include "results/statistics/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "parameters/designs/kind.hpp"
#include "parameters/designs/variation.hpp"
#include "results/ledger/effect_tables.hpp"
#include "results/statistics/depth_bands.hpp"
#include "results/statistics/propagation_convergence.hpp"
#include "results/statistics/stored_design.hpp"
#include "results/statistics/window_effects.hpp"
#include "solver/channels.hpp"

namespace cpt::results {

// Each in its file in designs/.
void add_pairs_effects(WindowEffects& window);
void add_morris_effects(WindowEffects& window);
void add_latin_hypercube_effects(WindowEffects& window);
void add_sobol_effects(WindowEffects& window);
void add_propagation_effects(WindowEffects& window);

namespace {

struct Estimator {
  std::string_view design;
  void (*add)(WindowEffects& window);
  std::string_view converging = "";  ///< the index whose convergence is told; empty: none
};
constexpr std::array estimators = {
    Estimator{"pairs", add_pairs_effects},
    Estimator{"morris", add_morris_effects, "mu_star"},
    Estimator{"latin_hypercube", add_latin_hypercube_effects, "total_order"},
    Estimator{"sobol", add_sobol_effects, "total_order"},
    Estimator{"propagation", add_propagation_effects},
};

const Estimator* estimator_of(std::string_view design) {
  const auto found = std::ranges::find(estimators, design, &Estimator::design);
  return found == estimators.end() ? nullptr : &*found;
}

// Runs that stand and fall together: a trajectory, a row.
Eigen::Index group_of(const parameters::Design& design) {
  if (design.kind == "morris") return parameters::width_of(design) + 1;
  return design.kind == "sobol" ? parameters::width_of(design) + 2 : 1;
}

std::string error_words(const parameters::Design& design) {
  std::string words;
  for (std::size_t k = 0; k < design.numerical_error.size(); ++k)
    if (const double error = design.numerical_error[k]; error > 0.0)
      words +=
          fmt::format("{}{:g} % of {}", words.empty() ? "" : ", ", 100.0 * error, solver::channels()[k].name);
  return words;
}

constexpr int convergence_steps = 6;

}  // namespace

std::string repeats_so_far(const Snapshot& s) {
  std::size_t all = 0, waiting = 0;
  for (const RealizationRow& run : s.realizations)
    if (run.side == "repeat") ++all, waiting += run.waiting() ? 1 : 0;
  return waiting == 0 ? "" : fmt::format("{} of {} repeats so far", all - waiting, all);
}

Effects design_effects(const Snapshot& s) {
  Effects effects;
  const StoredDesign stored = stored_design(s);
  effects.problem = stored.problem;
  if (!stored.study || stored.runs.empty()) return effects;
  effects.design = stored.study->design.kind;
  effects.stopped = stored.stopped;
  effects.numerical_error = error_words(stored.study->design);
  for (const RealizationRow* run : stored.runs)
    if (run != nullptr) effects.runs.push_back(run->id);
  const Estimator* estimator = estimator_of(effects.design);
  if (estimator == nullptr) return effects;
  for (const WindowRow& row : s.windows) {
    WindowEffects window(*stored.study, s, row, stored.runs, effects.rows);
    estimator->add(window);
    if (effects.design == "propagation") add_convergence(window, effects.convergence);
  }
  effects.bands = design_bands(stored, s);
  return effects;
}

void add_index_convergence(const Snapshot& s, Effects& effects) {
  const Estimator* estimator = estimator_of(effects.design);
  if (estimator == nullptr || estimator->converging.empty()) return;
  const StoredDesign stored = stored_design(s);
  const auto all = static_cast<Eigen::Index>(stored.runs.size()), group = group_of(stored.study->design);
  for (const WindowRow& row : s.windows) {
    std::vector<EffectRow> steps;
    for (int step = 1; step < convergence_steps; ++step) {
      WindowEffects window(*stored.study, s, row, stored.runs, steps);
      const Eigen::Index first = all / group * step / convergence_steps * group;
      if (first == 0) continue;
      window.y.tail(all - first).setConstant(parameters::undefined);
      const std::size_t before = steps.size();
      estimator->add(window);
      for (EffectRow& estimate : std::span(steps).subspan(before))  // what is to come has not been dropped
        estimate.dropped -= static_cast<int>((all - first) / group);
    }
    for (const std::vector<EffectRow>* found : {&std::as_const(steps), &std::as_const(effects.rows)})
      for (const EffectRow& estimate : *found)
        if (estimate.window == row.name && estimate.quantity == estimator->converging &&
            std::isfinite(estimate.value))
          effects.index_convergence.push_back(estimate);
  }
}

Table effects_table(const Effects& effects) { return table_of(effect_table(), effects.rows); }

Table index_convergence_table(const Effects& effects) {
  return table_of(effect_table(), effects.index_convergence);
}

Table bands_table(const Effects& effects) { return table_of(depth_band_table(), effects.bands); }

}  // namespace cpt::results

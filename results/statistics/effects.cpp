#include "results/statistics/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <variant>

#include "results/ledger/effect_tables.hpp"
#include "results/statistics/depth_bands.hpp"
#include "results/statistics/propagation_convergence.hpp"
#include "results/statistics/stored_design.hpp"
#include "results/statistics/window_effects.hpp"

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
  const StoredDesign stored = stored_design(s);
  effects.problem = stored.problem;
  if (!stored.study || stored.runs.empty()) return effects;
  effects.design = stored.study->design.kind;
  effects.stopped = stored.stopped;
  for (const RealizationRow* run : stored.runs)
    if (run != nullptr) effects.runs.push_back(run->id);
  const auto estimator = std::ranges::find(estimators, effects.design, &Estimator::design);
  if (estimator == estimators.end()) return effects;
  for (const WindowRow& row : s.windows) {
    WindowEffects window(*stored.study, s, row, stored.runs, effects.rows);
    estimator->add(window);
    if (effects.design == "propagation") add_convergence(window, effects.convergence);
  }
  effects.bands = design_bands(stored, s);
  return effects;
}

Table effects_table(const Effects& effects) { return table_of(effect_table(), effects.rows); }

Table bands_table(const Effects& effects) { return table_of(depth_band_table(), effects.bands); }

}  // namespace cpt::results

#include "results/statistics/window_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "parameters/designs/variation.hpp"

namespace cpt::results {

std::string missing_runs(Runs runs) {
  const std::set<const RealizationRow*> stored(runs.begin(), runs.end());
  const auto failed = std::count_if(stored.begin(), stored.end(),
                                    [](const auto* run) { return run != nullptr && run->failed(); });
  const auto waiting = std::count_if(stored.begin(), stored.end(),
                                     [](const auto* run) { return run == nullptr || run->waiting(); });
  std::string words;
  if (failed > 0) words = fmt::format("{} of {} runs failed", failed, stored.size());
  if (waiting > 0)
    words += failed > 0 ? fmt::format(", {} still to run", waiting)
                        : fmt::format("{} of {} runs still to run", waiting, stored.size());
  return words;
}

std::string runs_out_of_line(Runs runs) {
  const std::set<const RealizationRow*> stored(runs.begin(), runs.end());
  const auto lie = std::count_if(stored.begin(), stored.end(),
                                 [](const auto* run) { return run != nullptr && !run->out_of_line.empty(); });
  return lie > 0 ? fmt::format("{} of {} runs out of line", lie, stored.size()) : "";
}

WindowEffects::WindowEffects(const parameters::Study& of, const Snapshot& stored, const WindowRow& of_window,
                             Runs of_design, std::vector<EffectRow>& to)
    : study(of), snapshot(stored), window(of_window), runs(of_design), rows(to) {
  std::map<int, double> mean;
  for (const WindowMeanRow& m : snapshot.window_means)
    if (m.window == window.name) mean[m.realization] = m.q_c_mean_kPa;
  y = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(runs.size()), parameters::undefined);
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (runs[k] != nullptr && mean.contains(runs[k]->id))
      y(static_cast<Eigen::Index>(k)) = mean.at(runs[k]->id);
  note = window.problem.empty() ? missing_runs(runs) : "undefined: " + window.problem;
  constant = window.problem.empty() && parameters::is_constant(y);
  if (const std::string lies = runs_out_of_line(runs); !lies.empty()) append(lies);
  remarks = note;
  if (constant) prepend(parameters::does_not_vary);
}

void WindowEffects::prepend(std::string_view words) {
  note = note.empty() ? std::string(words) : fmt::format("{}; {}", words, note);
}

void WindowEffects::append(std::string_view words) {
  note = note.empty() ? std::string(words) : fmt::format("{}; {}", note, words);
}

std::string WindowEffects::name(std::size_t parameter) const {
  return std::string(study.rows[study.design.rows[parameter]].quantity->name);
}

void WindowEffects::put(std::size_t parameter, std::string_view quantity, std::string_view unit,
                        const parameters::Estimate& e, int used, int dropped, int with_results) {
  rows.push_back({window.name, name(parameter), "", std::string(quantity), std::string(unit), e.value,
                  e.lower, e.upper, used, dropped, note, method, with_results});
}

void WindowEffects::put_fit(double q2, int degree, int terms, int used, int dropped) {
  const std::string size = terms > 0 ? fmt::format("degree {}, {} terms", degree, terms) : "";
  rows.push_back({window.name, "", "", "Q2", "-", q2, parameters::undefined, parameters::undefined, used,
                  dropped, note + (note.empty() || size.empty() ? "" : "; ") + size,
                  "ten-fold cross-validation", used});
}

void WindowEffects::put_all(std::string_view quantity, const std::vector<parameters::Estimate>& estimates,
                            int used, int dropped, int with_results) {
  for (std::size_t j = 0; j < estimates.size(); ++j)
    put(j, quantity, "-", estimates[j], used, dropped, with_results);
}

}  // namespace cpt::results

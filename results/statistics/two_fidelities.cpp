#include "results/statistics/two_fidelities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>

#include "parameters/designs/multifidelity.hpp"
#include "parameters/designs/propagation.hpp"
#include "results/emulator/emulated_level.hpp"
#include "results/files/error.hpp"
#include "results/statistics/stored_design.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {
namespace {

using parameters::Estimate;
using parameters::Levels;

constexpr std::array<std::pair<std::string_view, double>, 5> fidelity_quantiles = {{{"quantile_05", 0.05},
                                                                                    {"quantile_25", 0.25},
                                                                                    {"quantile_50", 0.50},
                                                                                    {"quantile_75", 0.75},
                                                                                    {"quantile_95", 0.95}}};

StoredDesign propagation_of(const Snapshot& snapshot) {
  StoredDesign design = stored_design(snapshot);
  const std::string& name = snapshot.campaign.name;
  if (!design.problem.empty()) throw Error(fmt::format("{}: {}", name, design.problem));
  if (design.study->design.kind != "propagation" || design.runs.empty())
    throw Error(fmt::format("{}: has no runs of a [design] with kind = \"propagation\"", name));
  return design;
}

std::set<std::string_view> rows_of_design(const StoredDesign& design) {
  std::set<std::string_view> names;
  for (const std::size_t row : design.study->design.rows)
    names.insert(design.study->rows[row].quantity->name);
  return names;
}

// By realization, then quantity.
std::map<int, std::map<std::string, double>> inputs_of(const Snapshot& snapshot) {
  std::map<int, std::map<std::string, double>> inputs;
  for (const InputRow& row : snapshot.inputs) inputs[row.realization][row.quantity] = row.value;
  return inputs;
}

void require_pairs(const Snapshot& dear, const StoredDesign& few, const Snapshot& cheap,
                   const StoredDesign& many) {
  if (rows_of_design(few) != rows_of_design(many))
    throw Error(fmt::format("{} and {} are no pair: their designs vary other rows", dear.campaign.name,
                            cheap.campaign.name));
  const auto baseline = [](const Snapshot& snapshot) { return snapshot.realizations.front().settings_hash; };
  if (!dear.realizations.empty() && !cheap.realizations.empty() && baseline(dear) == baseline(cheap))
    throw Error(
        fmt::format("{} and {} are no pair: their baselines have the same settings, so that none is cheaper",
                    dear.campaign.name, cheap.campaign.name));
  auto mine = inputs_of(dear), other = inputs_of(cheap);
  for (std::size_t k = 0; k < std::min(few.runs.size(), many.runs.size()); ++k) {
    if (few.runs[k] == nullptr || many.runs[k] == nullptr) continue;
    for (const std::string_view row : rows_of_design(few)) {
      const std::string name(row);
      if (mine[few.runs[k]->id][name] == other[many.runs[k]->id][name]) continue;
      throw Error(
          fmt::format("{} and {} are no pair: in run {} of the design {} is {:.10g} and {:.10g}; give both "
                      "the same distributions, seed and sampling",
                      dear.campaign.name, cheap.campaign.name, k + 1, name, mine[few.runs[k]->id][name],
                      other[many.runs[k]->id][name]));
    }
  }
}

FidelityLevel level_of(const Snapshot& snapshot, const StoredDesign& design) {
  FidelityLevel level{snapshot.campaign.name, snapshot.campaign.preset, 0, 0.0};
  for (const RealizationRow* run : design.runs)
    if (run != nullptr && run->completed()) level.seconds_a_run += run->wall_s, ++level.runs;
  if (level.runs > 0) level.seconds_a_run /= level.runs;
  return level;
}

// A third level, or none and a warning.
void add_emulator(TwoFidelities& both, const parameters::Study& cheap, Levels& levels) {
  FidelityWindow& window = both.windows.back();
  const EmulatedLevel emulated =
      emulated_level(cheap, levels[1], std::max<Eigen::Index>(both.emulated_runs, levels[1].size()));
  window.emulator_q2 = emulated.q2;
  if (emulated.q2 >= least_emulated_q2) {
    levels.push_back(emulated.y);
    window.emulator_correlation = parameters::level_correlation(levels, 2);
  } else {
    both.warnings.push_back(
        std::isnan(emulated.q2)
            ? fmt::format("{}: too few cheap runs for an emulator; it is left out", window.window)
            : fmt::format("{}: the emulator of the cheap runs has Q2 = {:.3f} at runs held out, below {}; it "
                          "is left out",
                          window.window, emulated.q2, least_emulated_q2));
  }
}

void add_window(TwoFidelities& both, const std::string& window, const std::string& unit, Levels levels,
                const parameters::Study& cheap) {
  const bool latin = cheap.design.latin;
  const double cost_ratio = both.cheap.seconds_a_run / both.dear.seconds_a_run;
  const double rho = parameters::level_correlation(levels, 1);
  both.windows.push_back({window, static_cast<int>(parameters::paired_runs(levels)), rho,
                          parameters::variance_ratio(rho, cost_ratio),
                          parameters::best_run_ratio(rho, cost_ratio)});
  if (both.emulated_runs > 0) add_emulator(both, cheap, levels);
  const auto alone = [&](int least, const std::function<double(const Eigen::VectorXd&)>& number) {
    return parameters::by_sections(levels[0], least, number, latin);
  };
  both.rows.push_back({window, unit, "mean", alone(1, [](const Eigen::VectorXd& y) { return y.mean(); }),
                       parameters::combined_mean(levels, latin)});
  both.rows.push_back({window, unit, "standard_deviation",
                       alone(2, [](const Eigen::VectorXd& y) { return parameters::sample_deviation(y); }),
                       parameters::combined_deviation(levels, latin)});
  for (const auto& [name, probability] : fidelity_quantiles)
    both.rows.push_back(
        {window, unit, std::string(name),
         alone(2, [p = probability](const Eigen::VectorXd& y) { return parameters::sample_quantile(y, p); }),
         parameters::combined_quantile(levels, probability, latin)});
}

std::vector<std::string> other_signs(const Snapshot& dear, const Snapshot& cheap) {
  std::vector<std::string> warnings;
  for (const SensitivityRow& mine : dear.sensitivity)
    for (const SensitivityRow& other : cheap.sensitivity)
      if (mine.window == other.window && mine.parameter == other.parameter && mine.si * other.si < 0.0 &&
          mine.above_noise.value_or(true) && other.above_noise.value_or(true))
        warnings.push_back(fmt::format(
            "{} in window {} has an SI of {:+.3f} in {} and of {:+.3f} in {}: do not let "
            "the cheap runs speak for it",
            mine.parameter, mine.window, mine.si, dear.campaign.name, other.si, cheap.campaign.name));
  return warnings;
}

}  // namespace

TwoFidelities two_fidelities(const Snapshot& dear, const Snapshot& cheap, int emulated_runs) {
  const StoredDesign few = propagation_of(dear), many = propagation_of(cheap);
  require_pairs(dear, few, cheap, many);
  TwoFidelities both{level_of(dear, few),      level_of(cheap, many), {}, {},
                     other_signs(dear, cheap), emulated_runs};
  if (both.dear.runs == 0 || both.cheap.runs == 0)
    throw Error(fmt::format("{} has no completed run of its design",
                            both.dear.runs == 0 ? both.dear.name : both.cheap.name));
  std::vector<EffectRow> unused;
  for (const WindowRow& window : dear.windows) {
    const auto same = std::ranges::find(cheap.windows, window.name, &WindowRow::name);
    if (same == cheap.windows.end() || !window.problem.empty() || !same->problem.empty()) continue;
    add_window(both, window.name, std::string(window.unit()),
               {WindowEffects(*few.study, dear, window, few.runs, unused).y,
                WindowEffects(*many.study, cheap, *same, many.runs, unused).y},
               *many.study);
  }
  if (both.windows.empty())
    throw Error(fmt::format("{} and {} have no window in common", dear.campaign.name, cheap.campaign.name));
  return both;
}

Table fidelity_table(const TwoFidelities& both) {
  Table table{{"window", "quantity", "unit", "alone", "alone_lower", "alone_upper", "combined",
               "combined_lower", "combined_upper", "width_ratio"},
              {}};
  for (const FidelityRow& row : both.rows) {
    std::vector<Cell> cells = {row.window, row.quantity, row.unit};
    for (const Estimate* estimate : {&row.alone, &row.combined})
      for (const double value : {estimate->value, estimate->lower, estimate->upper})
        cells.push_back(number_cell(value));
    cells.push_back(
        number_cell((row.combined.upper - row.combined.lower) / (row.alone.upper - row.alone.lower)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace cpt::results

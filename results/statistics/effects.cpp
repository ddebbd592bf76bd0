#include "results/statistics/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <variant>

#include "parameters/all_realizations.hpp"
#include "parameters/designs/design.hpp"
#include "parameters/designs/morris.hpp"
#include "parameters/designs/pairs.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "parameters/designs/sobol.hpp"
#include "parameters/designs/variation.hpp"
#include "parameters/read_study.hpp"

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using parameters::Design;
using parameters::Estimate;
using parameters::Study;
using parameters::undefined;

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

// "2 of 44 runs failed, 1 still to run"; empty if all are completed. A run that the design asks for twice is
// one.
std::string missing(std::span<const RealizationRow* const> runs) {
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

// "2 of 44 runs out of line"; empty if none is.
std::string out_of_line(std::span<const RealizationRow* const> runs) {
  const std::set<const RealizationRow*> stored(runs.begin(), runs.end());
  const auto lie = std::count_if(stored.begin(), stored.end(),
                                 [](const auto* run) { return run != nullptr && !run->out_of_line.empty(); });
  return lie > 0 ? fmt::format("{} of {} runs out of line", lie, stored.size()) : "";
}

/// Adds the rows of one window.
class WindowEffects {
 public:
  WindowEffects(const Study& study, const Snapshot& s, const WindowRow& window,
                std::span<const RealizationRow* const> runs, std::vector<EffectRow>& rows)
      : study_(study), s_(s), window_(window), runs_(runs), rows_(rows) {
    std::map<int, double> mean;
    for (const WindowMeanRow& m : s.window_means)
      if (m.window == window.name) mean[m.realization] = m.q_c_mean_kPa;
    y_ = VectorXd::Constant(static_cast<Index>(runs.size()), undefined);
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (runs[k] != nullptr && mean.contains(runs[k]->id)) y_(static_cast<Index>(k)) = mean.at(runs[k]->id);
    note_ = window.problem.empty() ? missing(runs) : "undefined: " + window.problem;
    constant_ = window.problem.empty() && parameters::is_constant(y_);
    if (constant_) prepend(parameters::does_not_vary);
    if (const std::string lies = out_of_line(runs); !lies.empty()) append(lies);
  }

  void add() {
    switch (study_.design.kind) {
      case Design::Kind::one_at_a_time:
        return;
      case Design::Kind::pairs:
        return add_pairs();
      case Design::Kind::morris:
        return add_morris();
      case Design::Kind::latin_hypercube:
        return add_chaos();
      case Design::Kind::sobol:
        return add_sobol();
    }
  }

 private:
  void prepend(std::string_view words) {
    note_ = note_.empty() ? std::string(words) : fmt::format("{}; {}", words, note_);
  }
  void append(std::string_view words) {
    note_ = note_.empty() ? std::string(words) : fmt::format("{}; {}", note_, words);
  }
  [[nodiscard]] std::size_t parameters() const { return study_.design.rows.size(); }
  [[nodiscard]] std::string name(std::size_t j) const {
    return std::string(study_.rows[study_.design.rows[j]].quantity->name);
  }

  void put(std::size_t j, std::string_view quantity, std::string_view unit, const Estimate& e, int used,
           int dropped) {
    rows_.push_back({window_.name, name(j), "", std::string(quantity), std::string(unit), e.value, e.lower,
                     e.upper, used, dropped, note_});
  }

  // Why there is no interval from them.
  [[nodiscard]] std::string without_repeats() const {
    const auto is_repeat = [](const RealizationRow& run) { return run.side == "repeat"; };
    if (std::ranges::none_of(s_.realizations, is_repeat)) return "no interval: the study has no repeats";
    const bool waiting = std::ranges::any_of(
        s_.realizations, [&](const RealizationRow& run) { return is_repeat(run) && run.waiting(); });
    return waiting ? "no interval until the repeats have run" : "no interval: too few repeats completed";
  }
  // An interval from some of them is not the one to come.
  [[nodiscard]] std::string some_repeats() const {
    const std::string so_far = repeats_so_far(s_);
    return so_far.empty() ? "" : "interval of " + so_far;
  }

  // Without runs beside each other the interval is that of the repeats, each result scattering by the same
  // share of its size: an interaction is half of four results added up.
  void add_pairs() {
    const auto noise = std::find_if(s_.repeat_noise.begin(), s_.repeat_noise.end(),
                                    [&](const auto& row) { return row.window == window_.name; });
    const bool repeated = noise != s_.repeat_noise.end();
    const double scatter = repeated ? noise->si_half_width / std::sqrt(2.0) : undefined;  // t s / mean
    const auto pairs = parameters::pairs_of(static_cast<int>(parameters()));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto y = y_.segment<4>(4 * static_cast<Index>(k));
      const double value = constant_ ? undefined : parameters::interaction({y(0), y(1), y(2), y(3)});
      const double half = 0.5 * y.norm() * scatter;
      const int used = static_cast<int>(y.array().isFinite().count());
      const auto runs = runs_.subspan(4 * k, 4);
      const std::string gap = window_.problem.empty() ? missing(runs) : window_.problem;
      std::string note = gap.empty() ? "" : "undefined: " + gap;
      if (constant_) note = parameters::does_not_vary;
      if (note.empty()) note = repeated ? some_repeats() : without_repeats();
      if (const std::string lies = out_of_line(runs); !lies.empty())
        note += (note.empty() ? "" : "; ") + lies;
      rows_.push_back({window_.name, name(static_cast<std::size_t>(pairs[k].first)),
                       name(static_cast<std::size_t>(pairs[k].second)), "interaction", "kPa", value,
                       value - half, value + half, used, 4 - used, std::move(note)});
    }
  }

  void add_morris() {
    const auto effects =
        parameters::elementary_effects(parameters::design_places(study_), y_, study_.design.seed);
    const auto add = [&](std::string_view quantity, auto estimate) {
      for (std::size_t j = 0; j < effects.size(); ++j)
        put(j, quantity, "kPa", effects[j].*estimate, effects[j].used, effects[j].dropped);
    };
    add("mu_star", &parameters::ElementaryEffects::mu_star);
    add("mu", &parameters::ElementaryEffects::mu);
    add("sigma", &parameters::ElementaryEffects::sigma);
  }

  void add_sobol() {
    const auto indices = parameters::sobol_indices(static_cast<int>(parameters()), y_, study_.design.seed);
    // A and B alone may not vary.
    if (!constant_ && indices.used > 1 && std::isnan(indices.total.front().value))
      prepend(parameters::does_not_vary);
    add_shares(indices.first, indices.total, indices.used, indices.dropped);
  }

  void add_chaos() {
    std::vector<int> values;
    for (const std::size_t row : study_.design.rows)
      values.push_back(parameters::values_of(study_.rows[row]));
    const auto fit =
        parameters::polynomial_chaos(parameters::design_places(study_), values, y_, study_.design.seed);
    if (window_.problem.empty() && !fit.problem.empty() && !constant_) prepend(fit.problem);
    add_shares(fit.first, fit.total, fit.used, fit.dropped);
    std::string note = note_;
    if (fit.terms > 0)
      note += fmt::format("{}degree {}, {} terms", note.empty() ? "" : "; ", fit.degree, fit.terms);
    rows_.push_back({window_.name, "", "", "Q2", "-", fit.q2, undefined, undefined, fit.used, fit.dropped,
                     std::move(note)});
  }

  void add_shares(const std::vector<Estimate>& first, const std::vector<Estimate>& total, int used,
                  int dropped) {
    for (std::size_t j = 0; j < total.size(); ++j) put(j, "total_order", "-", total[j], used, dropped);
    for (std::size_t j = 0; j < first.size(); ++j) put(j, "first_order", "-", first[j], used, dropped);
  }

  const Study& study_;
  const Snapshot& s_;
  const WindowRow& window_;
  std::span<const RealizationRow* const> runs_;
  std::vector<EffectRow>& rows_;
  VectorXd y_;
  bool constant_ = false;  // the result does not vary
  std::string note_;
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
  effects.design = to_string(study.design.kind);
  for (const WindowRow& window : s.windows) WindowEffects(study, s, window, runs, effects.rows).add();
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

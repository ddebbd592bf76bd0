#include "validation/paper/index_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "reports/labels.hpp"
#include "reports/units.hpp"
#include "results/statistics/window_noise.hpp"
#include "validation/paper/own_extreme.hpp"
#include "validation/paper/ranking.hpp"

namespace cpt::validation::paper {
namespace {

using drawing::decimals, drawing::number, drawing::table_head, drawing::table_line;
using reports::baseline_run, reports::bound_run, reports::curve_of, reports::depth_range, reports::kPa,
    reports::parameter_of, reports::repeat_noise_of, reports::sensitivity_in, reports::symbol_of,
    reports::unit_of;

using results::SensitivityRow;
using results::Snapshot;

constexpr std::array<const Ranking*, 4> rankings = {&sand_ranking, &clay_ranking, &embedded_sand_ranking,
                                                    &embedded_clay_ranking};

const Ranking* ranking_of(std::string_view study, std::string_view window) {
  for (const Ranking* ranking : rankings)
    if (ranking->study == study && ranking->window == window) return ranking;
  return nullptr;
}

std::optional<results::WindowNoise> noise_at(const Snapshot& campaign, const results::WindowRow& window,
                                             std::string_view parameter, std::string_view side) {
  const results::RealizationRow* own = bound_run(campaign, parameter, side);
  const results::RealizationRow* run = own != nullptr ? own : baseline_run(campaign);
  const solver::DepthProfile* curve =
      run != nullptr && run->completed() ? curve_of(campaign, run->id) : nullptr;
  if (curve == nullptr) return std::nullopt;
  return results::window_noise(*curve, {window.from_m, window.to_m});
}

// "0.524 ± 0.012", or why there is none.
std::string index_cell(const Snapshot& s, const SensitivityRow& row) {
  if (!std::isfinite(row.si)) return row.note.empty() ? "–" : row.note;
  const auto interval = index_interval(s, row.window, row.parameter);
  return decimals(row.si, 3) + (interval ? " ± " + decimals(interval->half_width, 3) : "");
}

std::string index_beside(const StudyView& beside, const SensitivityRow& row) {
  const Value index = beside.index(row.window, row.parameter);
  return index ? decimals(index.number, 3) : "–";
}

// "0.231 (0.3088, 0.3113 m)": the index about each run's own extreme, and where they lie.
std::string own_extreme_cell(const Snapshot& s, const results::WindowRow& window, const SensitivityRow& row) {
  const auto own = own_extremes(s, window, row.parameter);
  if (!own) return "–";
  return fmt::format("{} ({}, {} m)", decimals(own->si, 3), decimals(own->at_lower, 4),
                     decimals(own->at_upper, 4));
}

std::string yes_or_no(std::optional<bool> answer) { return answer ? (*answer ? "yes" : "no") : "–"; }

std::string scatter_of(const results::RepeatNoiseRow& noise) {
  return fmt::format(
      "{} runs of the baseline with shifted material points average {} kPa and scatter by {} kPa, which "
      "gives "
      "the 95 % intervals and says what is noise: ±{} for an index near 0.\n\n",
      noise.runs, number(noise.q_c_mean_kPa, 4), number(noise.q_c_deviation_kPa, 3),
      decimals(noise.si_half_width, 3));
}

std::string how_else(const Snapshot& s, const results::WindowRow& window) {
  const bool any = std::ranges::any_of(s.sensitivity, [&](const SensitivityRow& row) {
    return row.window == window.name && index_interval(s, row.window, row.parameter);
  });
  return any ? "Without repeats of the baseline: 95 % intervals by batch means along each run's own curve; "
               "SI<sub>noise</sub> says what is noise.\n\n"
             : "Without repeats of the baseline: SI<sub>noise</sub> says what is noise.\n\n";
}

// Indices that rest on runs out of line, with what is.
std::string doubts_of(const Snapshot& s, const std::vector<SensitivityRow>& rows) {
  std::string out;
  for (const SensitivityRow& row : rows)
    if (row.note.find("out of line") != row.note.npos)
      out += fmt::format("- {}: {}\n", html(symbol_of(s, parameter_of(s, row.parameter))), row.note);
  return out.empty() ? out : "\n" + out;
}

std::string window_table(const StudyView& view, const results::WindowRow& window, const Ranking* ranking,
                         const StudyView* beside) {
  const Snapshot& s = *view.snapshot();
  std::vector<SensitivityRow> rows = sensitivity_in(s, window.name);
  std::stable_sort(rows.begin(), rows.end(), [](const SensitivityRow& a, const SensitivityRow& b) {
    return (std::isfinite(a.si_abs) ? a.si_abs : -1.0) > (std::isfinite(b.si_abs) ? b.si_abs : -1.0);
  });
  std::string out = fmt::format("\n### {}, window {}\n\n", s.campaign.name, window.name);
  if (window.problem.empty())
    out += fmt::format("{}, baseline {} kPa, SI<sub>noise</sub> {}.\n\n",
                       depth_range(window.from_m, window.to_m), number(view.baseline(window.name).number, 4),
                       decimals(view.noise(window.name).number, 4));
  else
    out += window.problem + ".\n\n";
  const results::RepeatNoiseRow* repeats = repeat_noise_of(s, window.name);
  out += repeats != nullptr ? scatter_of(*repeats) : how_else(s, window);
  std::vector<std::string> columns = {"parameter", "bounds", "q<sub>c</sub> (kPa)", "SI"};
  if (beside != nullptr)
    columns.push_back("SI beside" + (beside->snapshot() != nullptr
                                         ? ", " + beside->snapshot()->campaign.preset
                                         : std::string()));
  const bool moves = window.kind != "fixed" && window.problem.empty();
  if (moves) columns.push_back(fmt::format("SI at each run's own {} (depths at the bounds)", window.kind));
  columns.push_back("above noise");
  if (repeats != nullptr) columns.push_back("above SI<sub>noise</sub> (the paper's)");
  if (ranking != nullptr) columns.push_back("the paper's group");
  out += table_head(columns);
  for (const SensitivityRow& row : rows) {
    const results::ParameterRow& p = parameter_of(s, row.parameter);
    std::vector<std::string> cells = {
        html(symbol_of(s, p) + unit_of(p)), p.lower_text + " to " + p.upper_text,
        number(row.q_lower_kPa, 4) + " to " + number(row.q_upper_kPa, 4), index_cell(s, row)};
    if (beside != nullptr) cells.push_back(index_beside(*beside, row));
    if (moves) cells.push_back(own_extreme_cell(s, window, row));
    cells.push_back(yes_or_no(row.above_noise));
    if (repeats != nullptr) cells.push_back(yes_or_no(row.above_si_noise));
    if (ranking != nullptr) cells.push_back(group_of(*ranking, row.parameter));
    out += table_line(cells);
  }
  return out + doubts_of(s, rows);
}

}  // namespace

std::optional<IndexInterval> index_interval(const Snapshot& campaign, std::string_view window,
                                            std::string_view parameter) {
  const auto place = std::find_if(campaign.windows.begin(), campaign.windows.end(),
                                  [&](const results::WindowRow& w) { return w.name == window; });
  const auto row =
      std::find_if(campaign.sensitivity.begin(), campaign.sensitivity.end(),
                   [&](const SensitivityRow& r) { return r.window == window && r.parameter == parameter; });
  if (place == campaign.windows.end() || row == campaign.sensitivity.end() || !std::isfinite(row->si))
    return std::nullopt;
  if (std::isfinite(row->si_half_width)) return IndexInterval{row->si_half_width, true};
  if (campaign.layers.size() != 1) return std::nullopt;
  const auto lower = noise_at(campaign, *place, parameter, "lower");
  const auto upper = noise_at(campaign, *place, parameter, "upper");
  if (!lower || !upper) return std::nullopt;
  return IndexInterval{
      results::index_uncertainty(row->q_lower_kPa * kPa, *lower, row->q_upper_kPa * kPa, *upper), false};
}

std::string index_tables(const Studies& studies, const Studies* beside) {
  const Studies none;
  std::string out;
  for (const std::string_view name : study_names()) {
    const StudyView view(studies, name);
    if (view.snapshot() == nullptr) continue;
    const StudyView other(beside != nullptr ? *beside : none, name);
    for (const results::WindowRow& window : view.snapshot()->windows)
      out += window_table(view, window, ranking_of(name, window.name), beside != nullptr ? &other : nullptr);
  }
  return out;
}

}  // namespace cpt::validation::paper

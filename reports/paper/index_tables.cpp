#include "reports/paper/index_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/labels.hpp"
#include "reports/paper/markdown.hpp"
#include "reports/paper/ranking.hpp"
#include "reports/text.hpp"
#include "results/window_noise.hpp"

namespace cpt::reports::paper {
namespace {

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

std::string si_cell(const SensitivityRow& row) {
  return std::isfinite(row.si) ? decimals(row.si, 3) : std::string("–");
}

std::string window_table(const Snapshot& s, const StudyView& view, std::string_view study,
                         const results::WindowRow& window) {
  std::vector<SensitivityRow> rows = sensitivity_in(s, window.name);
  std::stable_sort(rows.begin(), rows.end(), [](const SensitivityRow& a, const SensitivityRow& b) {
    return (std::isfinite(a.si_abs) ? a.si_abs : -1.0) > (std::isfinite(b.si_abs) ? b.si_abs : -1.0);
  });
  const Ranking* ranking = ranking_of(study, window.name);
  const Value noise = view.noise(window.name);
  std::string out = fmt::format("\n### {}, window {}\n\n", study, window.name);
  if (window.problem.empty())
    out += fmt::format("{}, baseline {} kPa, SI<sub>noise</sub> {}.\n\n",
                       depth_range(window.from_m, window.to_m), number(view.baseline(window.name).number, 4),
                       decimals(noise.number, 4));
  else
    out += window.problem + ".\n\n";
  out += table_head({"parameter", "bounds", "q<sub>c</sub> lower (kPa)", "q<sub>c</sub> upper (kPa)", "SI",
                     "95 % interval", "above SI<sub>noise</sub>", "the paper says", "note"});
  for (const SensitivityRow& row : rows) {
    const results::ParameterRow& p = parameter_of(s, row.parameter);
    const auto half = index_interval(s, window.name, row.parameter);
    out += table_line({html(symbol_of(s, p) + unit_of(p)), p.lower_text + " – " + p.upper_text,
                       number(row.q_lower_kPa, 4), number(row.q_upper_kPa, 4), si_cell(row),
                       half ? "±" + decimals(*half, 3) : std::string("–"),
                       row.above_noise ? (*row.above_noise ? "yes" : "no") : "–",
                       std::string(ranking != nullptr ? words_for(*ranking, row.parameter) : ""), row.note});
  }
  return out;
}

}  // namespace

std::optional<double> index_interval(const Snapshot& campaign, std::string_view window,
                                     std::string_view parameter) {
  if (campaign.layers.size() != 1) return std::nullopt;
  const auto place = std::find_if(campaign.windows.begin(), campaign.windows.end(),
                                  [&](const results::WindowRow& w) { return w.name == window; });
  const auto row =
      std::find_if(campaign.sensitivity.begin(), campaign.sensitivity.end(),
                   [&](const SensitivityRow& r) { return r.window == window && r.parameter == parameter; });
  if (place == campaign.windows.end() || row == campaign.sensitivity.end() || !std::isfinite(row->si))
    return std::nullopt;
  const auto lower = noise_at(campaign, *place, parameter, "lower");
  const auto upper = noise_at(campaign, *place, parameter, "upper");
  if (!lower || !upper) return std::nullopt;
  constexpr double kPa = 1.0e3;
  return results::index_uncertainty(row->q_lower_kPa * kPa, *lower, row->q_upper_kPa * kPa, *upper);
}

std::string index_tables(const Studies& studies) {
  std::string out;
  for (const std::string_view name : study_names()) {
    const StudyView view(studies, name);
    if (view.snapshot() == nullptr) continue;
    for (const results::WindowRow& window : view.snapshot()->windows)
      out += window_table(*view.snapshot(), view, name, window);
  }
  return out;
}

}  // namespace cpt::reports::paper

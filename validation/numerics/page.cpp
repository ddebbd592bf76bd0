#include "validation/numerics/page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drawing/markdown.hpp"
#include "drawing/text.hpp"
#include "reports/labels.hpp"
#include "validation/numerics/sentences.hpp"
#include "validation/numerics/systematic.hpp"

namespace cpt::validation::numerics {
namespace {

using drawing::decimals, drawing::number, drawing::table_head, drawing::table_line;
using reports::depth_range, reports::state_of;

using results::Snapshot;

constexpr std::string_view head = R"(# Numerical uncertainty

How far the numerics alone move the average tip resistance q̄<sub>c</sub>: the mesh, the number of material points, the time
step, the mass scaling and the speed of the push, each changed alone, and repeats of one push whose material points start
elsewhere (`numerics.point_shift`). Written by

    scripts/numerical-uncertainty

from the campaigns of `examples/numerics`.

- **Repeats** give the noise: the standard deviation s of q̄<sub>c</sub> over them. One more run lies within t s √(1 + 1/n) of
  their mean with a probability of 95 %; a setting that moves q̄<sub>c</sub> by more does something. Two runs whose SI is below
  √2 t s / q̄<sub>c</sub> cannot be told apart; beside it stands SI<sub>noise</sub>, the spread of q<sub>c</sub> inside the
  window of one run, by which Yost et al. (2023) judge.
- **Meshes** of refinement r have cells of 1/r the size, the same grading and as many material points a cell. Three of them
  give the observed order of convergence, the value at cell size zero and the grid convergence index (GCI, safety factor 1.25:
  Roache 1994; Celik et al. 2008). Where q̄<sub>c</sub> does not move one way, half the range over the three stands in its place
  (Stern et al. 2001).
)";

std::string kilopascals(std::optional<double> value) { return value ? number(*value, 4) : "–"; }

std::string presets(const std::vector<NumericsStudy>& studies) {
  std::string out = "\n## Presets\n\nBaselines of the profiles at the presets, as far as they were run.\n\n";
  out += table_head({"profile", "preset", "window", "q̄<sub>c</sub> (kPa)", "SI<sub>noise</sub>",
                     "material points", "steps"});
  for (const NumericsStudy& study : studies) {
    const Snapshot& s = study.campaign;
    const int baseline = study.repeats.front();
    const results::RealizationRow* row = run_row(s, baseline);
    if (row == nullptr || !row->completed()) continue;
    for (const results::WindowRow& window : s.windows) {
      const auto noise = noise_in(s, baseline, window.name);
      out += table_line({s.campaign.profile, s.campaign.preset, depth_range(window.from_m, window.to_m),
                         kilopascals(mean_in(s, baseline, window.name)), noise ? decimals(*noise, 4) : "–",
                         fmt::format("{}", row->material_points), fmt::format("{}", row->steps)});
    }
  }
  return out;
}

std::string repeats_table(const NumericsStudy& study) {
  std::string out = "\n";
  out += table_head({"window", "repeats", "mean q̄<sub>c</sub> (kPa)", "s (kPa)", "s / mean",
                     "smallest SI told from chance", "SI<sub>noise</sub> of the baseline"});
  const Snapshot& s = study.campaign;
  for (const results::WindowRow& window : s.windows) {
    const auto repeats = repeats_in(study, window.name);
    const auto noise = noise_in(s, study.repeats.front(), window.name);
    const std::string name = fmt::format("{}, {}", window.name, depth_range(window.from_m, window.to_m));
    if (!repeats) {
      out += table_line({name, "fewer than 3", "–", "–", "–", "–", noise ? decimals(*noise, 4) : "–"});
      continue;
    }
    out += table_line({name, fmt::format("{}", repeats->runs), number(repeats->mean, 4),
                       number(repeats->deviation, 2), percent(repeats->deviation / repeats->mean, 2),
                       repeats->deviation > 0.0 ? decimals(results::index_half_width(*repeats), 4)
                                                : "undefined: the result does not vary",
                       noise ? decimals(*noise, 4) : "–"});
  }
  return out;
}

std::string settings_table(const NumericsStudy& study) {
  const Snapshot& s = study.campaign;
  std::vector<std::string> columns = {"setting", "value", "material points", "steps"};
  for (const results::WindowRow& window : s.windows)
    columns.push_back(fmt::format("q̄<sub>c</sub> {} (kPa)", window.name));
  std::string out =
      "\nEvery run; in brackets the change against the mean of the repeats, bold where it is more than they "
      "explain.\n\n";
  out += table_head(columns);
  for (const Setting& setting : study.settings)
    for (const Run& run : setting.runs) {
      const results::RealizationRow* row = run_row(s, run.realization);
      if (row == nullptr) continue;
      std::vector<std::string> cells = {
          fmt::format("{}, `{}`", words(setting), setting.quantity->name),
          value_text(setting, run.value) + (run.value == setting.baseline ? ", baseline" : ""),
          row->completed() ? fmt::format("{}", row->material_points) : row->status,
          row->completed() ? fmt::format("{}", row->steps) : "–"};
      for (const results::WindowRow& window : s.windows) {
        const auto q_c = mean_in(s, run.realization, window.name),
                   reference = reference_in(study, window.name);
        if (!q_c || !reference) {
          cells.emplace_back("–");
          continue;
        }
        const auto repeats = repeats_in(study, window.name);
        const bool told = told_from_repeats(*q_c, *reference, repeats);
        const std::string change = percent(*q_c / *reference - 1.0);
        cells.push_back(
            fmt::format("{} ({})", number(*q_c, 4), told ? fmt::format("**{}**", change) : change));
      }
      out += table_line(cells);
    }
  return out;
}

std::string mesh_table(const NumericsStudy& study) {
  std::string rows;
  for (const results::WindowRow& window : study.campaign.windows)
    for (const MeshTriple& triple : mesh_triples(study, window.name)) {
      const auto& [fine, medium, coarse] = triple.meshes;
      rows += table_line(
          {window.name,
           fmt::format("{}, {}, {}", triple.refinement[0], triple.refinement[1], triple.refinement[2]),
           fmt::format("{}, {}, {}", number(fine.value, 4), number(medium.value, 4), number(coarse.value, 4)),
           decimals(triple.error.order, 2), number(triple.error.extrapolated, 4),
           std::isfinite(triple.error.band) ? percent(triple.error.band) : "–"});
    }
  if (rows.empty()) return "";
  std::string out = "\nMeshes.\n\n";
  out += table_head({"window", "refinements", "q̄<sub>c</sub> (kPa)", "observed order",
                     "at cell size zero (kPa)", "error band of the finest"});
  return out + rows;
}

std::string section(const NumericsStudy& study, const std::string& figures) {
  const Snapshot& s = study.campaign;
  std::string out =
      fmt::format("\n## {}\n\nPreset {}, {}.\n", s.campaign.title, s.campaign.preset, state_of(s));
  for (const results::WindowRow& window : s.windows) {
    const std::string found = sentences(study, window.name);
    out += fmt::format("\nWindow {}, {}:\n\n{}", window.name, depth_range(window.from_m, window.to_m),
                       found.empty() ? "- nothing to compare yet\n" : found);
  }
  out += fmt::format("\n![{}]({}/{}.svg)\n", s.campaign.title, figures, s.campaign.name);
  return out + repeats_table(study) + settings_table(study) + mesh_table(study);
}

}  // namespace

std::string page(const std::vector<NumericsStudy>& studies, const std::string& figures) {
  std::string out(head);
  out += presets(studies);
  out += systematic_section(studies);
  for (const NumericsStudy& study : studies)
    if (!study.settings.empty()) out += section(study, figures);
  return out;
}

}  // namespace cpt::validation::numerics

#include "validation/paper/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drawing/markdown.hpp"
#include "reports/labels.hpp"
#include "validation/paper/compare.hpp"
#include "validation/paper/finding_tables.hpp"
#include "validation/paper/index_tables.hpp"
#include "validation/paper/push_measures.hpp"

namespace cpt::validation::paper {
namespace {

constexpr std::string_view opening =
    R"(# The numbers of Yost et al. (2023), and ours

<!-- Written by `campaign paper`; changes by hand are lost. -->

Yost, K. M., Martinelli, M., Yerro, A., Green, R. A., & de Lange, D. A. (2023). Computers and Geotechnics 158, 105378.
Our numbers come from the databases of the studies in `examples/paper` and from recorded pushes of the dense sand; the
paper's are quoted with their section (§). `scripts/reproduce-paper` runs everything and writes this page. Causes of
differences are written by hand in `docs/paper-causes.toml`.
)";

constexpr std::string_view not_in_the_text = R"(
## What the paper's text does not give

The paper prints its laboratory tests and recordings as figures only, so these are held against nothing:

| Fig. | the text gives | the text does not give | shown here |
| --- | --- | --- | --- |
| 3, 9, 10 | averages of q<sub>c</sub> | recordings | ours alone; `campaign diagnose` compares with recordings |
| 5 | critical state line, bounds of λ, 14 tests at D<sub>R</sub> = 1 % | measured paths, cell pressures | line and simulated tests |
| 6 | parameters, D<sub>R</sub> = 80, 51, 1 %, 12 tests | measured curves, cell pressures, each test's H | simulated tests at both bounds of H |
| 7 | H from 25 to 75, linear in ψ<sub>0</sub>, depends on p'<sub>0</sub> | the points, the line | H found again from simulated tests of known H |
| 8 | that the path is met well over the range of H | measured path, density, stresses | simulated path at D<sub>R</sub> = 36 % |

With triaxial tests of your own, `campaign element calibrate` makes the paper's Fig. 7.
)";

std::string percent_of(double fraction) { return fmt::format("{:.0f}", 100.0 * fraction); }

std::string study_table(const Studies& studies) {
  std::string out = drawing::table_head({"study", "preset", "state", "points", "hours", "solver"});
  for (const std::string_view name : study_names()) {
    const auto found = studies.find(name);
    if (found == studies.end()) {
      out += drawing::table_line({std::string(name), "", "not run", "", "", ""});
      continue;
    }
    const results::Snapshot& s = found->second;
    std::int64_t points = 0;
    double seconds = 0.0;
    for (const results::RealizationRow& run : s.realizations) {
      points = std::max(points, run.material_points);
      if (!run.waiting()) seconds += run.wall_s;
    }
    out += drawing::table_line({std::string(name), s.campaign.preset, reports::state_of(s),
                                fmt::format("{}", points), fmt::format("{:.2f}", seconds / 3600.0),
                                s.campaign.solver_version});
  }
  return out;
}

std::string what_was_run(const Studies& studies, const Studies* beside) {
  std::string out = "\n## What was run\n\n" + study_table(studies);
  if (beside != nullptr) out += "\nBeside it:\n\n" + study_table(*beside);
  return out + "\nPoints: material points of a realization. Hours: of all realizations together.\n";
}

std::string other_preset(const Studies& studies) {
  if (presets_of(studies) == "paper") return "";
  return R"(
**Some of these ran at another resolution than the paper's (preset `paper`): their levels are not to be held against
it.**
)";
}

std::string figure_section(const std::vector<FigureGroup>& groups) {
  std::string out = "\n## Figures\n";
  for (const FigureGroup& group : groups) {
    if (group.figures.empty()) continue;
    out += fmt::format("\n### {}\n", group.title);
    for (const LinkedFigure& figure : group.figures)
      out += fmt::format("\n![{}]({})\n\n{}\n", figure.caption, figure.file, figure.caption);
  }
  return out;
}

std::string method() {
  return fmt::format(
      R"(
## How the checks are made

- Level: an average q<sub>c</sub> lies within {0} % of the paper's. Effect: a relative change has the paper's sign and lies
  within {1} points of it. Sign: q<sub>c</sub> moves the way the paper says, however little.
- Order: the paper names its parameters in groups, from the largest influence to the least. Every pair of parameters from
  different groups is compared by |SI|; the check holds if all pairs are in the paper's order.
- Side of SI<sub>noise</sub>: a parameter that the paper puts above the noise has |SI| > SI<sub>noise</sub>, one that it puts at or
  below has not. SI and SI<sub>noise</sub> are equation 3 and section 5.1 of the paper (`docs/schema.md`).
- SI ± its 95 % interval, from repeats: the baseline again with its grid of material points shifted against the mesh
  (`repeats` in the study). Both averages of SI are single runs that scatter by the same share of their size, s / mean of
  the repeats; to first order SI is known to ± √2 t s / mean × q<sub>lower</sub> / q<sub>upper</sub>. It is above the noise
  where |SI| exceeds that. SI<sub>noise</sub>, which holds the trend of q<sub>c</sub> through the window too, stands beside.
- SI ± its 95 % interval, by batch means, in a study without repeats: windows of the same width, side by side above and
  below the one used, are averaged on the same curve. Their scatter about a straight trend with depth is the standard
  deviation of one average (up to ten windows). Both runs' deviations enter SI to first order and as independent, with
  Student's t and Welch's degrees of freedom. It speaks of noise along the curve alone: errors of the mesh, the time step or
  the model that are alike at all depths are not in it. A layered soil has no stretch with a trend of its own, so there is
  no interval.
- SI at each run's own peak or trough: both runs are averaged over an interval as wide as the window's about their own
  extreme, where it lies inside the depths in which the window seeks the baseline's. It leaves out what the fixed window
  adds where an input moves the extreme.
- Where a bound equals the baseline, the baseline's run stands for it. B1, M1 and M2 are averaged over 0.1 to 0.7 m, as the
  experiments are in section 3.2; the paper does not name its window there.
- Paths (B1): for the material points that start nearest to 1, 2 and 3 cone radii from the axis, 0.5 m deep, the mean
  distance between two paths in the p'–q plane at equal depth of the tip, over the mean distance of the path for
  σ'<sub>h0</sub> = 50 kPa from the origin. Mean p' is that over the whole push, averaged over the three points.
- Wall (W1): mean stresses of the outermost material points between the depths that the figure names; the largest rise is
  over all of these and the whole push. The stress, not its rise, is to lie within {0} % of the paper's.
- Void ratio (D1): means over rings a tenth of the cone's diameter wide, over the middle half of the push. A ring counts as
  altered if its void ratio has changed by more than {2} % of the largest contraction; the paper does not say what it
  counts.
)",
      percent_of(level_tolerance), percent_of(effect_tolerance), percent_of(altered_part));
}

}  // namespace

std::string page(const Runs& runs, const std::vector<Cause>& causes, const std::vector<FigureGroup>& figures,
                 const Runs* beside) {
  const Studies* studies_beside = beside != nullptr ? &beside->studies : nullptr;
  return std::string(opening) + other_preset(runs.studies) + "\n## Result by result\n\n" +
         finding_tables(runs, causes, beside) + "\n## Sensitivity indices\n" +
         index_tables(runs.studies, studies_beside) + std::string(not_in_the_text) + figure_section(figures) +
         what_was_run(runs.studies, studies_beside) + method();
}

}  // namespace cpt::validation::paper

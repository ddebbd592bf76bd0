#include "reports/paper/page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/labels.hpp"
#include "reports/paper/compare.hpp"
#include "reports/paper/findings.hpp"
#include "reports/paper/index_tables.hpp"
#include "reports/paper/markdown.hpp"

namespace cpt::reports::paper {
namespace {

constexpr std::string_view opening =
    R"(# The numbers of Yost et al. (2023), and ours

<!-- Written by `campaign paper`; changes by hand are lost. -->

Yost, K. M., Martinelli, M., Yerro, A., Green, R. A., & de Lange, D. A. (2023). Computers and Geotechnics 158, 105378.
Our numbers come from the databases of the studies in `examples/paper`; the paper's are quoted with their section.
`scripts/reproduce-paper` runs the studies and writes this page.
)";

std::string percent_of(double fraction) { return fmt::format("{:.0f}", 100.0 * fraction); }

std::string study_table(const Studies& studies) {
  std::string out = table_head({"study", "preset", "state", "material points", "million steps",
                                "hours of realizations", "solver", "program"});
  for (const std::string_view name : study_names()) {
    const auto found = studies.find(name);
    if (found == studies.end()) {
      out += table_line({std::string(name), "", "not run", "", "", "", "", ""});
      continue;
    }
    const results::Snapshot& s = found->second;
    std::int64_t steps = 0, points = 0;
    double seconds = 0.0;
    for (const results::RealizationRow& run : s.realizations) {
      steps += run.steps;
      points = std::max(points, run.material_points);
      if (!run.waiting()) seconds += run.wall_s;
    }
    out += table_line({std::string(name), s.campaign.preset, state_of(s), fmt::format("{}", points),
                       fmt::format("{:.2f}", static_cast<double>(steps) * 1e-6),
                       fmt::format("{:.2f}", seconds / 3600.0), s.campaign.solver_version,
                       s.campaign.program_version});
  }
  return out;
}

std::string what_was_run(const Studies& studies, const Studies* beside) {
  std::string out = "\n## What was run\n\n" + study_table(studies);
  if (beside != nullptr) out += "\nBeside it:\n\n" + study_table(*beside);
  const bool other = std::any_of(studies.begin(), studies.end(),
                                 [](const auto& study) { return study.second.campaign.preset != "paper"; });
  if (other)
    out += R"(
**Some of these ran at another resolution than the paper's (preset `paper`): their levels are not to be held against
it.**
)";
  return out;
}

std::string tally(const std::vector<Finding>& findings) {
  const auto count = [&](Verdict verdict) {
    return std::count_if(findings.begin(), findings.end(),
                         [&](const Finding& f) { return f.verdict == verdict; });
  };
  return fmt::format("{} checks hold, {} differ, {} numbers are shown without a check, {} are not run.\n\n",
                     count(Verdict::holds), count(Verdict::differs), count(Verdict::shown),
                     count(Verdict::not_run));
}

// `beside` is empty or has the same findings in the same order.
std::string finding_table(const std::vector<Finding>& findings, const std::vector<Finding>& beside) {
  std::string out = "\n## Result by result\n\n" + tally(findings);
  std::vector<std::string> columns = {"#",          "what",  "paper",   "section", "ours",
                                      "difference", "check", "verdict", "preset"};
  if (!beside.empty()) columns.insert(columns.end(), {"beside it", "verdict", "preset"});
  out += table_head(columns);
  const auto or_dash = [](const std::string& text) { return text.empty() ? std::string("–") : text; };
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& f = findings[i];
    std::vector<std::string> cells = {std::string(f.row),
                                      f.quantity,
                                      f.published,
                                      std::string(f.section),
                                      or_dash(f.ours),
                                      f.difference,
                                      f.check,
                                      std::string(to_string(f.verdict)),
                                      f.preset};
    if (!beside.empty())
      cells.insert(cells.end(),
                   {or_dash(beside[i].ours), std::string(to_string(beside[i].verdict)), beside[i].preset});
    out += table_line(cells);
  }
  return out;
}

// Findings that differ, or have something missing, with their detail.
std::string details(const std::vector<Finding>& findings) {
  std::string out;
  for (const Finding& f : findings)
    if (!f.detail.empty()) out += fmt::format("- {}, {}: {}.\n", f.row, f.quantity, f.detail);
  return out.empty() ? out : "\n## What is out of line or missing\n\n" + out;
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

- Level: an average q<sub>c</sub> lies within {} % of the paper's. Effect: a relative change has the paper's sign and lies
  within {} points of it. Sign: q<sub>c</sub> moves the way the paper says, however little.
- Order: the paper names its parameters in groups, from the largest influence to the least. Every pair of parameters from
  different groups is compared by |SI|; the check holds if all pairs are in the paper's order.
- Side of SI<sub>noise</sub>: a parameter that the paper puts above the noise has |SI| > SI<sub>noise</sub>, one that it puts at or
  below has not. SI and SI<sub>noise</sub> are equation 3 and section 5.1 of the paper (`docs/schema.md`).
- 95 % interval of SI: windows of the same width, side by side above and below the one used, are averaged on the same
  curve. Their scatter about a straight trend with depth is the standard deviation of one average (batch means, up to ten
  windows). Both runs' deviations enter SI to first order and as independent, with Student's t and Welch's degrees of
  freedom. It speaks of noise along the curve alone: errors of the mesh, the time step or the model that
  are alike at all depths are not in it. A layered soil has no stretch with a trend of its own, so there is no interval.
- Where a bound equals the baseline, the baseline's run stands for it. B1, M1 and M2 are averaged over 0.1 to 0.7 m, as the
  experiments are in section 3.2; the paper does not name its window there.
)",
      percent_of(level_tolerance), percent_of(effect_tolerance));
}

}  // namespace

std::string page(const Studies& studies, const std::vector<FigureGroup>& figures, const Studies* beside) {
  const std::vector<Finding> findings = all_findings(studies);
  return std::string(opening) + what_was_run(studies, beside) +
         finding_table(findings, beside != nullptr ? all_findings(*beside) : std::vector<Finding>{}) +
         details(findings) + "\n## Sensitivity indices\n" + index_tables(studies) + figure_section(figures) +
         method();
}

}  // namespace cpt::reports::paper

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drawing/text.hpp"
#include "reports/labels.hpp"
#include "validation/paper/compare.hpp"
#include "validation/paper/findings.hpp"

namespace cpt::validation::paper {
namespace {

// Least and largest of the averages of a study, each with the label of the realization it belongs to.
struct Extremes {
  Value least, largest;
  std::string least_run, largest_run;  // Markdown
  std::string partial;                 // realizations that are missing from it
  bool waiting = false;                // some of them are still to run
};

/// Of all completed realizations, with or without the upper bound of one parameter.
Extremes extremes(const StudyView& study, std::string_view window, std::string_view without = {}) {
  if (const Value base = study.baseline(window); !base) return {base, base, {}, {}, {}, false};
  const results::Snapshot& s = *study.snapshot();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Extremes ends{{infinity, {}}, {-infinity, {}}, {}, {}, {}, false};
  int found = 0, missing = 0;
  for (const results::RealizationRow& run : s.realizations) {
    if (!without.empty() && run.parameter == without && run.side == "upper") continue;
    const auto mean = std::find_if(s.window_means.begin(), s.window_means.end(), [&](const auto& m) {
      return m.realization == run.id && m.window == window;
    });
    if (mean == s.window_means.end()) {
      ++missing;
      ends.waiting = ends.waiting || run.waiting();
      continue;
    }
    ++found;
    const double q_c = mean->q_c_mean_kPa;
    if (q_c < ends.least.number) ends.least.number = q_c, ends.least_run = html(reports::run_label(s, run));
    if (q_c > ends.largest.number)
      ends.largest.number = q_c, ends.largest_run = html(reports::run_label(s, run));
  }
  if (missing > 0)
    ends.partial = fmt::format("{} of {} realizations are in the range", found, found + missing);
  return ends;
}

void add_range(std::vector<Finding>& findings, std::string_view row, const std::string& of,
               const Extremes& range, const Published& least, const Published& largest) {
  for (const bool low : {true, false}) {
    Finding finding = compare_level({row, (low ? "least " : "largest ") + of}, low ? least : largest,
                                    low ? range.least : range.largest);
    if (finding.verdict == Verdict::differs)
      finding.detail = "belongs to " + (low ? range.least_run : range.largest_run);
    if (range.waiting) finding.verdict = Verdict::not_run;  // the next one may change it
    if (!range.partial.empty()) finding.detail += (finding.detail.empty() ? "" : "; ") + range.partial;
    findings.push_back(std::move(finding));
  }
}

// That the largest index belongs to H, and by far: the paper's own ranges put it at 1.5 times the next or
// more.
constexpr double by_far = 1.5;

Finding dominance(const StudyView& study) {
  const Value first = study.index("sand", inputs::hardening);
  Finding finding = not_run({"S2", "H dominates by far"}, "by far the largest SI", "5.2", first.missing);
  finding.check = fmt::format("order: {:g} times the next", by_far);
  if (!first) return finding;
  double next = 0.0;
  std::string_view name;
  for (const Group& group : sand_ranking.groups)
    for (const std::string_view parameter : group.parameters) {
      const Value index = study.index("sand", parameter);
      if (parameter == inputs::hardening || !index || std::abs(index.number) <= next) continue;
      next = std::abs(index.number);
      name = parameter;
    }
  if (name.empty()) {
    finding.detail = "no other parameter has an index";
    return finding;
  }
  finding.ours = fmt::format("SI {}; next {} {}", drawing::decimals(first.number, 3), study.symbol(name),
                             drawing::decimals(next, 3));
  finding.verdict = first.number >= by_far * next ? Verdict::holds : Verdict::differs;
  return finding;
}

Finding several_above(const StudyView& study) {
  const RankingComparison known = compare(study, sand_ranking);
  Finding finding = not_run({"S3", "parameters with SI > 0.2"}, "several", "6.3", known.missing);
  if (known.levels == 0) return finding;
  int count = 0;
  for (const Group& group : sand_ranking.groups)
    for (const std::string_view parameter : group.parameters) {
      const Value index = study.index("sand", parameter);
      if (index && std::abs(index.number) > 0.2) ++count;
    }
  finding.ours = fmt::format("{}", count);
  finding.check = "more than one";
  finding.verdict = count > 1 ? Verdict::holds : Verdict::differs;
  if (count <= 1 && !known.missing.empty()) finding.verdict = Verdict::not_run;  // the next one may change it
  return finding;
}

// How q_c changes from a chamber of 0.45 m to one of 0.30 m.
Value on_shrinking(const StudyView& study) {
  return relative_change(study.q_c("sand", inputs::radius, Bound::upper),
                         study.q_c("sand", inputs::radius, Bound::lower));
}

Value on_raising_sigma_h0(const StudyView& study) {
  return relative_change(study.q_c("sand", inputs::sigma_h0, Bound::lower),
                         study.q_c("sand", inputs::sigma_h0, Bound::upper));
}

}  // namespace

std::vector<Finding> sand_findings(const Studies& studies) {
  const StudyView rigid(studies, sand_study);
  const StudyView flexible(studies, flexible_study);
  std::vector<Finding> findings;
  add_range(findings, "S1", "average q<sub>c</sub>, all but H = 75",
            extremes(rigid, "sand", inputs::hardening), sand_least, sand_largest);
  findings.push_back(compare_level({"S2", "average q<sub>c</sub>, H = 75"}, sand_hard,
                                   rigid.q_c("sand", inputs::hardening, Bound::upper)));
  findings.push_back(dominance(rigid));
  compare_ranking(findings, "S3", sand_ranking, rigid);
  findings.push_back(several_above(rigid));
  findings.push_back(show({"S3", "|SI| of the chamber's radius"}, radius_index,
                          magnitude(rigid.index("sand", inputs::radius)), 3, ""));
  findings.push_back(show({"S3", "SI<sub>noise</sub>"}, noise_sand, rigid.noise("sand"), 4, ""));
  findings.push_back(compare_sign({"S4", "rigid wall: σ'<sub>h0</sub> 15 → 35 kPa"},
                                  "q<sub>c</sub> falls very slightly", "5.2", Sign::falls,
                                  on_raising_sigma_h0(rigid)));
  findings.push_back(compare_sign({"S4", "rigid wall: radius 0.45 → 0.30 m"}, "q<sub>c</sub> rises slightly",
                                  "5.2", Sign::rises, on_shrinking(rigid)));
  findings.push_back(compare_sign({"S5", "flexible wall: σ'<sub>h0</sub> 15 → 35 kPa"},
                                  "q<sub>c</sub> rises clearly", "5.2", Sign::rises,
                                  on_raising_sigma_h0(flexible)));
  findings.push_back(compare_sign({"S5", "flexible wall: radius 0.45 → 0.30 m"}, "q<sub>c</sub> falls", "5.2",
                                  Sign::falls, on_shrinking(flexible)));
  findings.push_back(compare_less({"S5", "|SI| of σ'<sub>h0</sub>, rigid against flexible wall"},
                                  "far less with the rigid wall", "5.2",
                                  magnitude(rigid.index("sand", inputs::sigma_h0)),
                                  magnitude(flexible.index("sand", inputs::sigma_h0)), 0.5));
  return findings;
}

std::vector<Finding> clay_findings(const Studies& studies) {
  const StudyView study(studies, clay_study);
  std::vector<Finding> findings;
  findings.push_back(
      compare_level({"C1", "average q<sub>c</sub>, baseline"}, clay_baseline, study.baseline("clay")));
  add_range(findings, "C1", "average q<sub>c</sub>", extremes(study, "clay"), clay_least, clay_largest);
  compare_ranking(findings, "C2", clay_ranking, study);
  findings.push_back(compare_sign({"C2", "σ'<sub>h0</sub> 15 → 35 kPa"}, "q<sub>c</sub> rises slightly",
                                  "5.2", Sign::rises,
                                  relative_change(study.q_c("clay", inputs::sigma_h0, Bound::lower),
                                                  study.q_c("clay", inputs::sigma_h0, Bound::upper))));
  findings.push_back(show({"C2", "SI<sub>noise</sub>"}, noise_clay, study.noise("clay"), 4, ""));
  return findings;
}

}  // namespace cpt::validation::paper

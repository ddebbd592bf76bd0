#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "drawing/text.hpp"
#include "validation/paper/compare.hpp"
#include "validation/paper/findings.hpp"

namespace cpt::validation::paper {
namespace {

constexpr std::string_view in_sand = "embedded_sand";
constexpr std::string_view in_clay = "embedded_clay";

Value window_centre(const StudyView& study, std::string_view name) {
  if (const Value q = study.baseline(name); !q) return q;
  const results::WindowRow* window = study.window(name);
  return {0.5 * (window->from_m + window->to_m), {}};
}

// Least or largest q_c of the baseline inside the window.
Value in_window(const StudyView& study, std::string_view window, bool least) {
  const Value mean = study.baseline(window);
  if (!mean) return mean;
  for (const results::WindowMeanRow& row : study.snapshot()->window_means)
    if (row.window == window && row.q_c_mean_kPa == mean.number)
      return {least ? row.q_c_min_kPa : row.q_c_max_kPa, {}};
  return mean;
}

// Mean |SI| of the parameters of `ranking`, in any window of any study that has them.
Value mean_index(const StudyView& study, std::string_view window, const Ranking& parameters) {
  double sum = 0.0;
  int count = 0;
  for (const Group& group : parameters.groups)
    for (const std::string_view parameter : group.parameters) {
      const Value index = study.index(window, parameter);
      if (!index) return index;
      sum += std::abs(index.number);
      ++count;
    }
  return {sum / count, {}};
}

}  // namespace

std::vector<Finding> layered_findings(const Studies& studies) {
  const StudyView study(studies, layered_study);
  std::vector<Finding> findings;
  compare_ranking(findings, "L1", embedded_sand_ranking, study);
  findings.push_back(compare_level({"L1", "least q<sub>c</sub> about the peak, baseline"}, peak_least,
                                   in_window(study, in_sand, true)));
  findings.push_back(compare_level({"L1", "largest q<sub>c</sub> about the peak, baseline"}, peak_largest,
                                   in_window(study, in_sand, false)));
  findings.push_back(show({"L1", "depth of the peak"}, peak_depth, window_centre(study, in_sand), 4, " m"));
  findings.push_back(show({"L1", "SI<sub>noise</sub>"}, noise_embedded_sand, study.noise(in_sand), 4, ""));
  compare_ranking(findings, "L2", embedded_clay_ranking, study);
  findings.push_back(
      show({"L2", "depth of the trough"}, trough_depth, window_centre(study, in_clay), 4, " m"));
  findings.push_back(show({"L2", "SI<sub>noise</sub>"}, noise_embedded_clay, study.noise(in_clay), 4, ""));

  const StudyView sand(studies, sand_study), clay(studies, clay_study);
  findings.push_back(
      compare_less({"L3", "mean |SI| of the sand study's parameters: embedded against homogeneous sand"},
                   "embedded layers are less sensitive", "6.1", mean_index(study, in_sand, sand_ranking),
                   mean_index(sand, "sand", sand_ranking)));
  findings.push_back(
      compare_less({"L3", "mean |SI| of the clay study's parameters: embedded against homogeneous clay"},
                   "embedded layers are less sensitive", "6.1", mean_index(study, in_clay, clay_ranking),
                   mean_index(clay, "clay", clay_ranking)));
  findings.push_back(compare_less({"L3", "mean |SI| of all parameters: embedded sand against embedded clay"},
                                  "embedded sand is less sensitive than embedded clay", "6.1",
                                  mean_index(study, in_sand, embedded_sand_ranking),
                                  mean_index(study, in_clay, embedded_clay_ranking)));
  return findings;
}

}  // namespace cpt::validation::paper

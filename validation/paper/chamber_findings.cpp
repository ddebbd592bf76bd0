#include <fmt/format.h>

#include "validation/paper/compare.hpp"
#include "validation/paper/findings.hpp"

namespace cpt::validation::paper {
namespace {

constexpr std::string_view whole_window = "whole";

Value on_raising(const StudyView& study, std::string_view parameter) {
  return relative_change(study.baseline(whole_window), study.q_c(whole_window, parameter, Bound::upper));
}

Findings boundary_findings(const StudyView& rigid, const StudyView& flexible) {
  const Value with_rigid = on_raising(rigid, inputs::sigma_h0),
              with_flexible = on_raising(flexible, inputs::sigma_h0);
  return {
      compare_sign({"B1", "q<sub>c</sub>, rigid wall: σ'<sub>h0</sub> 50 → 90 kPa"},
                   "nearly the same, 90 kPa slightly lower", "6.2", Sign::falls, with_rigid),
      compare_sign({"B1", "q<sub>c</sub>, flexible wall: σ'<sub>h0</sub> 50 → 90 kPa"},
                   "90 kPa clearly higher", "6.2", Sign::rises, with_flexible),
      compare_less({"B1", "size of that change, rigid against flexible wall"}, "far less with the rigid wall",
                   "6.2", magnitude(with_rigid), magnitude(with_flexible), 0.5)};
}

Findings second_push_findings(const StudyView& first, const StudyView& second) {
  const Value base = first.baseline(whole_window);
  const Value stress = relative_change(base, second.baseline(whole_window));
  const Value dense = on_raising(first, inputs::density);
  const Value together = !stress  ? stress
                         : !dense ? dense
                                  : Value{(1.0 + stress.number) * (1.0 + dense.number) - 1.0, {}};
  return {
      compare_effect({"M1", "σ'<sub>v0</sub> 100 → 120 kPa, σ'<sub>h0</sub> 50 → 60 kPa on q<sub>c</sub>"},
                     stress_effect, stress),
      compare_effect({"M2", "D<sub>R</sub> 60 → 65 % on q<sub>c</sub>"}, density_effect, dense),
      compare_effect({"M2", "M1 and M2 multiplied, against the measured rise"}, measured_rise, together),
      compare_effect({"M2", "both changes in one run, against the measured rise"}, measured_rise,
                     relative_change(base, second.q_c(whole_window, inputs::density, Bound::upper)))};
}

Finding recording_finding() {
  Finding finding =
      not_run({"F9", "baseline against the recording"}, "close, with some discrepancy at shallow depths", "5",
              "the recording of the homogeneous sand is not published as numbers; `campaign diagnose` does "
              "this with recordings that are");
  finding.verdict = Verdict::not_published;
  return finding;
}

}  // namespace

std::vector<Finding> chamber_findings(const Runs& runs) {
  const StudyView rigid(runs.studies, dense_rigid_study);
  Findings findings;
  for (Findings& part :
       std::vector<Findings>{boundary_findings(rigid, StudyView(runs.studies, dense_flexible_study)),
                             path_findings(runs.pushes),
                             wall_findings(runs.pushes),
                             second_push_findings(rigid, StudyView(runs.studies, second_push_study)),
                             void_ratio_findings(runs.pushes),
                             {recording_finding()}})
    findings.insert(findings.end(), part.begin(), part.end());
  return findings;
}

std::vector<FindingGroup> all_findings(const Runs& runs) {
  return {{"Homogeneous sand", sand_findings(runs.studies)},
          {"Homogeneous clay", clay_findings(runs.studies)},
          {"Layered soil", layered_findings(runs.studies)},
          {"Walls, second push, void ratio", chamber_findings(runs)}};
}

}  // namespace cpt::validation::paper

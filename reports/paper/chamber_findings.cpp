#include <fmt/format.h>

#include <cmath>

#include "reports/paper/compare.hpp"
#include "reports/paper/findings.hpp"

namespace cpt::reports::paper {
namespace {

constexpr std::string_view window = "whole";
constexpr std::string_view sigma_h0 = "initial.sigma_h0_kPa";
constexpr std::string_view density = "sand.D_r_percent";

Value size(const Value& value) { return {std::abs(value.number), value.missing}; }

Value on_raising(const StudyView& study, std::string_view parameter) {
  return relative_change(study.baseline(window), study.q_c(window, parameter, Bound::upper));
}

void add_boundaries(std::vector<Finding>& findings, const StudyView& rigid, const StudyView& flexible) {
  const Value with_rigid = on_raising(rigid, sigma_h0), with_flexible = on_raising(flexible, sigma_h0);
  findings.push_back(compare_sign({"B1", "rigid wall: σ'<sub>h0</sub> 50 → 90 kPa", rigid.preset()},
                                  "nearly the same, 90 kPa slightly lower", "6.2", Sign::falls, with_rigid));
  findings.push_back(compare_sign({"B1", "flexible wall: σ'<sub>h0</sub> 50 → 90 kPa", flexible.preset()},
                                  "90 kPa clearly higher", "6.2", Sign::rises, with_flexible));
  findings.push_back(
      compare_less({"B1", "size of that change, rigid against flexible wall", flexible.preset()},
                   "far less with the rigid wall", "6.2", size(with_rigid), size(with_flexible), 0.5));
  findings.push_back(
      not_run({"B1", "stress paths at 1, 2 and 3 cone radii, 0.5 m deep", ""},
              "nearly the same for both σ'<sub>h0</sub> with the rigid wall, different with the flexible one",
              "6.2", "the databases hold no stresses of material points"));
}

void add_wall(std::vector<Finding>& findings) {
  const std::string why = "the databases hold no stresses at the wall";
  findings.push_back(not_run({"W1", "largest σ'<sub>v</sub> at the wall over its initial value", ""},
                             "up to about " + percent(wall_sigma_v.value, 0), wall_sigma_v.section, why));
  findings.push_back(not_run({"W1", "largest σ'<sub>h</sub> at the wall over its initial value", ""},
                             "up to about " + percent(wall_sigma_h.value, 0), wall_sigma_h.section, why));
}

void add_second_push(std::vector<Finding>& findings, const StudyView& first, const StudyView& second) {
  const std::string preset = first.preset() == second.preset() || second.preset().empty()
                                 ? first.preset()
                                 : first.preset() + ", " + second.preset();
  const Value base = first.baseline(window);
  const Value stress = relative_change(base, second.baseline(window));
  const Value dense = on_raising(first, density);
  findings.push_back(compare_effect(
      {"M1", "σ'<sub>v0</sub> 100 → 120 kPa, σ'<sub>h0</sub> 50 → 60 kPa on q<sub>c</sub>", preset},
      stress_effect, stress));
  findings.push_back(compare_effect({"M2", "D<sub>R</sub> 60 → 65 % on q<sub>c</sub>", first.preset()},
                                    density_effect, dense));
  const Value added = !stress  ? stress
                      : !dense ? dense
                               : Value{(1.0 + stress.number) * (1.0 + dense.number) - 1.0, {}};
  findings.push_back(compare_effect({"M2", "M1 and M2 multiplied, against the measured rise", preset},
                                    measured_rise, added));
  findings.push_back(compare_effect({"M2", "both changes in one run, against the measured rise", preset},
                                    measured_rise,
                                    relative_change(base, second.q_c(window, density, Bound::upper))));
}

void add_rest(std::vector<Finding>& findings) {
  const std::string why = "the databases hold no void ratios";
  findings.push_back(not_run({"D1", "radius within which the void ratio is altered", ""},
                             fmt::format("about {:.0f} cm", 100.0 * altered_radius.value),
                             altered_radius.section, why));
  findings.push_back(not_run({"D1", "least void ratio at the end, from D<sub>R</sub> 60 %", ""},
                             fmt::format("{}", least_void_ratio.value), least_void_ratio.section, why));
  findings.push_back(
      not_run({"F9", "baseline against the recording", ""},
              "close, but for shallow depths, where the chamber's top and the heavy cushion act", "5",
              "the paper's recordings are not published as numbers"));
}

}  // namespace

std::vector<Finding> chamber_findings(const Studies& studies) {
  const StudyView rigid(studies, dense_rigid_study);
  std::vector<Finding> findings;
  add_boundaries(findings, rigid, StudyView(studies, dense_flexible_study));
  add_wall(findings);
  add_second_push(findings, rigid, StudyView(studies, second_push_study));
  add_rest(findings);
  return findings;
}

std::vector<Finding> all_findings(const Studies& studies) {
  std::vector<Finding> findings;
  for (const auto part : {sand_findings, clay_findings, layered_findings, chamber_findings})
    for (Finding& finding : part(studies)) findings.push_back(std::move(finding));
  return findings;
}

}  // namespace cpt::reports::paper

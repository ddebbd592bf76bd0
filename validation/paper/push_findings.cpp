// Stress paths, wall stresses and void ratios of the recorded pushes.
#include <fmt/format.h>

#include <cmath>

#include "validation/paper/compare.hpp"
#include "validation/paper/findings.hpp"
#include "validation/paper/push_measures.hpp"

namespace cpt::validation::paper {
namespace {

// Mean over the points at 1, 2 and 3 cone radii.
Value mean_stress_change(const Push& first, const Push& second) {
  double sum = 0.0;
  for (const int radii : {1, 2, 3}) {
    const Value change = mean_stress_change(first, second, radii);
    if (!change) return change;
    sum += change.number;
  }
  return {sum / 3.0, {}};
}

}  // namespace

std::vector<Finding> path_findings(const Pushes& pushes) {
  std::vector<Finding> findings;
  for (const int radii : {1, 2, 3})
    findings.push_back(compare_less(
        {"B1", fmt::format("distance of the p'–q paths at {} cone {}, rigid against flexible wall", radii,
                           radii == 1 ? "radius" : "radii")},
        "nearly identical; quite different", "6.2", path_distance(pushes.rigid, pushes.rigid_90, radii),
        path_distance(pushes.flexible, pushes.flexible_90, radii), 0.5));
  findings.push_back(compare_sign({"B1", "rigid wall: mean p' of those paths, 50 → 90 kPa"},
                                  "slightly smaller", "6.2", Sign::falls,
                                  mean_stress_change(pushes.rigid, pushes.rigid_90)));
  findings.push_back(compare_sign({"B1", "flexible wall: mean p' of those paths, 50 → 90 kPa"},
                                  "generally larger", "6.2", Sign::rises,
                                  mean_stress_change(pushes.flexible, pushes.flexible_90)));
  return findings;
}

std::vector<Finding> wall_findings(const Pushes& pushes) {
  return {compare_stress_rise({"W1", "largest rise of σ'<sub>v</sub> at the wall"}, wall_sigma_v,
                              largest_wall_rise(pushes.rigid, "sigma_v")),
          compare_stress_rise({"W1", "largest rise of σ'<sub>h</sub> at the wall"}, wall_sigma_h,
                              largest_wall_rise(pushes.rigid, "sigma_r")),
          compare_nearer({"W1", "σ'<sub>h</sub>/σ'<sub>v</sub> at the wall, at the end"},
                         "much closer to 1.0 than 0.5", wall_ratio, wall_ratio_start,
                         final_wall_ratio(pushes.rigid))};
}

std::vector<Finding> void_ratio_findings(const Pushes& pushes) {
  const Push& push = pushes.rigid;
  return {show({"D1", "radius within which the void ratio is altered"}, altered_to, altered_radius(push), 2,
               " m"),
          compare_change({"D1", "change of void ratio next to the cone"}, "dilation", altered_to.section,
                         Sign::rises, change_beside_cone(push), 3),
          compare_change({"D1", "largest change of void ratio beyond, mean of a ring"}, "contraction",
                         altered_to.section, Sign::falls, largest_contraction(push), 3),
          show({"D1", "least void ratio at the end, mean of a ring"}, least_void_ratio,
               least_ring_void_ratio(push), 3, ""),
          show({"D1", "least void ratio at the end, single material point anywhere in the soil"},
               least_void_ratio, least_point_void_ratio(push), 3, "")};
}

}  // namespace cpt::validation::paper

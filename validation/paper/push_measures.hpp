// Single numbers that stand for what a recorded push shows in the paper's figures.
#pragma once

#include <string_view>
#include <vector>

#include "results/push/radial_profile.hpp"
#include "validation/paper/pushes.hpp"
#include "validation/paper/studies.hpp"

namespace cpt::validation::paper {

/// Stress paths of the material point that started about so many cone radii from the axis (1, 2 or 3) in two
/// pushes: the mean distance in the p'-q plane at equal depth of the tip, over the mean distance of the first
/// path from the origin [-].
[[nodiscard]] Value path_distance(const Push& first, const Push& second, int radii);

/// Mean p' along the path of that point, the second push's over the first's, minus one [-].
[[nodiscard]] Value mean_stress_change(const Push& first, const Push& second, int radii);

/// Largest rise of "sigma_v" or "sigma_r" beside the wall over its initial value [-], over the push and all
/// recorded depths.
[[nodiscard]] Value largest_wall_rise(const Push& push, std::string_view stress);

/// sigma'_h over sigma'_v beside the wall at the end of the push [-], mean over the recorded depths.
[[nodiscard]] Value final_wall_ratio(const Push& push);

/// Depths [m] over which void ratios are averaged: the middle half of the push, clear of the soil's top and
/// of the tip.
[[nodiscard]] results::DepthInterval middle_half(const results::Histories& push);

/// Rings of a tenth of the cone's diameter over these depths at the end.
[[nodiscard]] std::vector<results::Ring> void_ratio_rings(const results::Histories& push);

/// A ring counts as altered if its void ratio has changed by more than this part of the largest contraction.
inline constexpr double altered_part = 0.1;
/// Radius [m] of the outermost altered ring.
[[nodiscard]] Value altered_radius(const Push& push);

/// Change of void ratio [-] in the innermost ring, beside the shaft.
[[nodiscard]] Value change_beside_cone(const Push& push);
/// The largest contraction among the rings: their least change of void ratio [-].
[[nodiscard]] Value largest_contraction(const Push& push);
/// Least void ratio [-] of a ring, and of a single material point of all soil.
[[nodiscard]] Value least_ring_void_ratio(const Push& push);
[[nodiscard]] Value least_point_void_ratio(const Push& push);

}  // namespace cpt::validation::paper

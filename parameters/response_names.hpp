// What the averages of a window are called as columns of a table of samples.
#pragma once

#include <array>
#include <string>

namespace cpt::parameters {

/// Mean, least and largest: "deep.q_c_mean_kPa", "deep.q_c_min_kPa", "deep.q_c_max_kPa"; of what an external
/// program gives, in its unit, "late", "late.min", "late.max".
[[nodiscard]] inline std::array<std::string, 3> response_names(const std::string& window, bool external) {
  if (external) return {window, window + ".min", window + ".max"};
  return {window + ".q_c_mean_kPa", window + ".q_c_min_kPa", window + ".q_c_max_kPa"};
}

}  // namespace cpt::parameters

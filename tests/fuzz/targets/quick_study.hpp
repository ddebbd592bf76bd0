// The study of fuzzed requests, plans and ledgers.
#pragma once

#include <stdexcept>

#include "parameters/read_study.hpp"

namespace cpt::fuzz {

inline constexpr const char* quick_study_text = R"(
profile = "homogeneous_sand"
preset = "quick"
repeats = 2
[fixed]
"penetrometer.final_depth_m" = 0.35
[parameters]
"sand.D_r_percent" = { lower = 26, upper = 46 }
"chamber.wall" = { baseline = "rigid", alternative = "flexible" }
[[windows]]
name = "deep"
from_m = 0.2
to_m = 0.22
[design]
kind = "pairs"
)";

inline const parameters::Study& quick_study() {
  static const parameters::Study study = [] {
    auto read = parameters::parse_study(quick_study_text, "/studies/quick.toml");
    if (const auto* errors = std::get_if<1>(&read)) throw std::logic_error(parameters::format(*errors));
    return std::get<parameters::Study>(std::move(read));
  }();
  return study;
}

}  // namespace cpt::fuzz

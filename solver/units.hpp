// Units of study files, and what turns their numbers into SI.
#pragma once

#include <numbers>
#include <string_view>

namespace cpt::solver {

struct Unit {
  std::string_view text;
  double scale;  // SI value = scale * study value
};
inline constexpr Unit none{"-", 1.0};
inline constexpr Unit percent{"%", 0.01};
inline constexpr Unit degrees{"deg", std::numbers::pi / 180.0};
inline constexpr Unit kilopascals{"kPa", 1.0e3};
inline constexpr Unit metres{"m", 1.0};
inline constexpr Unit millimetres{"mm", 1.0e-3};
inline constexpr Unit millimetres_per_megapascal{"mm/MPa", 1.0e-9};
inline constexpr Unit kilopascals_per_metre{"kPa/m", 1.0e3};
inline constexpr Unit per_second{"1/s", 1.0};
inline constexpr Unit seconds{"s", 1.0};
inline constexpr Unit metres_per_second{"m/s", 1.0};
inline constexpr Unit kilograms_per_cubic_metre{"kg/m3", 1.0};

}  // namespace cpt::solver

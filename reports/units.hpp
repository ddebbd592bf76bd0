// Units of stress.
#pragma once

namespace cpt::reports {

inline constexpr double kPa = 1.0e3, MPa = 1.0e6;  // [Pa]

}  // namespace cpt::reports

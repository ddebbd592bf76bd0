// What the simulated element tests take from the laboratory's (Yost et al. 2023, section 4.2).
#pragma once

#include <array>

namespace cpt::validation::paper {

inline constexpr std::array laboratory_densities = {0.80, 0.51, 0.01};          // [-] D_R
inline constexpr std::array laboratory_pressures = {40.0e3, 160.0e3, 640.0e3};  // [Pa] over their range

}  // namespace cpt::validation::paper

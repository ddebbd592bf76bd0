#include "results/push/push_start.hpp"

namespace cpt::results {

std::size_t bins_of_start(const solver::DepthProfile& profile) {
  constexpr double reach = 2.0e-3;  // [m]
  constexpr double fall = 0.8;      // of the first bin's q_c
  std::size_t i = 0;
  while (i + 1 < profile.q_c.size() && profile.q_c[i + 1] < profile.q_c[i] &&
         profile.depth[i + 1] - profile.depth[0] <= reach)
    ++i;
  return i > 0 && profile.q_c[i] < fall * profile.q_c[0] ? i : 0;
}

}  // namespace cpt::results

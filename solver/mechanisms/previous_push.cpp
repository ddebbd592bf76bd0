#include "solver/mechanisms/previous_push.hpp"

#include <algorithm>

#include "solver/mechanisms/mechanism.hpp"
#include "solver/quantity_builders.hpp"

namespace cpt::solver {

namespace {

double between_bins(const std::vector<double>& values, double bin, double depth, double none_there) {
  if (values.empty()) return none_there;
  const double at = std::clamp(depth / bin - 0.5, 0.0, static_cast<double>(values.size() - 1));
  const auto k = std::min(static_cast<std::size_t>(at), values.size() - 1);
  const double next = values[std::min(k + 1, values.size() - 1)];
  return values[k] + (at - static_cast<double>(k)) * (next - values[k]);
}

}  // namespace

double LeftBehind::sigma_h(double depth) const { return between_bins(sigma_h_ratio, bin, depth, 1.0); }
double LeftBehind::void_ratio(double depth) const { return between_bins(void_ratio_change, bin, depth, 0.0); }

Mechanism previous_push_mechanism() {
  return {.name = "previous_push",
          .title = "stress and density left by a previous push",
          .equation =
              "sigma'_h(z), sigma'_v, e(z) from a simulated first push at the spacing; share of the change",
          .source = "Yost et al. (2023), section 6.3",
          .signature = "q_c is higher all along the depth of the first push, in about constant proportion.",
          .acts_on = any_soil,
          .parameters = {
              {number<&Setup::mechanisms, &Mechanisms::previous_push, &PreviousPush::share>(
                   "previous_push.share", "s_prev", none, 0.0, 3.0, any_soil,
                   "share of the first push's changes that this push starts with",
                   "Yost et al. (2023), section 6.3"),
               0.0, 1.5},
              {number<&Setup::mechanisms, &Mechanisms::previous_push, &PreviousPush::spacing>(
                   "previous_push.spacing_m", "d_prev", metres, 0.02, 5.0, any_soil,
                   "distance between the axes of the two pushes", "Yost et al. (2023), section 3.1: 0.26 m"),
               0.10, 0.26},  // the zone that decides the second q_c reaches towards the first push
              {number<&Setup::mechanisms, &Mechanisms::previous_push, &PreviousPush::stress_share>(
                   "previous_push.stress_share", "s_prev,σ", none, 0.0, 3.0, any_soil,
                   "part of the share that holds for the stress; 0: the density's effect alone",
                   "Yost et al. (2023), section 6.3.1"),
               1.0, 1.0},
              {number<&Setup::mechanisms, &Mechanisms::previous_push, &PreviousPush::void_ratio_share>(
                   "previous_push.void_ratio_share", "s_prev,e", none, 0.0, 3.0, any_soil,
                   "part of the share that holds for the void ratio; 0: the stress's effect alone",
                   "Yost et al. (2023), section 6.3.2"),
               1.0, 1.0},
              {number<&Setup::mechanisms, &Mechanisms::previous_push, &PreviousPush::depth>(
                   "previous_push.depth_m", "z_prev", metres, 0.0, 5.0, any_soil,
                   "depth that the first push reached; 0: that of this one",
                   "Yost et al. (2023), section 3.1: the whole profile"),
               0.0, 0.0}}};
}

}  // namespace cpt::solver

#include "parameters/designs/design.hpp"
#include "parameters/designs/morris.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

void add_morris_effects(WindowEffects& w) {
  const auto effects =
      parameters::elementary_effects(parameters::design_places(w.study), w.y, w.study.design.seed);
  w.method = "elementary effects, bootstrap over trajectories";
  const auto add = [&](std::string_view quantity, auto estimate) {
    for (std::size_t j = 0; j < effects.size(); ++j)
      w.put(j, quantity, w.window.unit(), effects[j].*estimate, effects[j].used, effects[j].dropped,
            2 * effects[j].used);
  };
  add("mu_star", &parameters::ElementaryEffects::mu_star);
  add("mu", &parameters::ElementaryEffects::mu);
  w.method = "elementary effects, Bonett's interval";
  add("sigma", &parameters::ElementaryEffects::sigma);
}

}  // namespace cpt::results

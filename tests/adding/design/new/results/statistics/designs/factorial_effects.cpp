#include "parameters/designs/design.hpp"
#include "parameters/designs/factorial.hpp"
#include "parameters/designs/variation.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

void add_factorial_effects(WindowEffects& w) {
  const Eigen::MatrixXd places = parameters::design_places(w.study);
  const int used = static_cast<int>(w.y.array().isFinite().count());
  for (std::size_t j = 0; j < w.study.design.rows.size(); ++j) {
    parameters::Estimate effect;
    if (!w.constant) effect.value = parameters::main_effect(places, w.y, static_cast<Eigen::Index>(j));
    w.put(j, "main_effect", "kPa", effect, used, static_cast<int>(w.y.size()) - used);
  }
}

}  // namespace cpt::results

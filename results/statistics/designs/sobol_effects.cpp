#include <cmath>

#include "parameters/designs/sobol.hpp"
#include "parameters/designs/variation.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

void add_sobol_effects(WindowEffects& w) {
  const auto indices =
      parameters::sobol_indices(parameters::width_of(w.study.design), w.y, w.study.design.seed);
  // A and B alone may not vary.
  if (!w.constant && indices.used > 1 && std::isnan(indices.total.front().value))
    w.prepend(parameters::does_not_vary);
  w.put_shares(indices.first, indices.total, indices.used, indices.dropped);
}

}  // namespace cpt::results

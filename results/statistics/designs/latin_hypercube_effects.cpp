#include "parameters/designs/design.hpp"
#include "parameters/designs/polynomial_chaos.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

void add_latin_hypercube_effects(WindowEffects& w) {
  std::vector<int> values;
  for (const std::size_t row : w.study.design.rows)
    values.push_back(parameters::values_of(w.study.rows[row]));
  const auto fit = parameters::polynomial_chaos(parameters::design_places(w.study), values, w.y);
  if (w.window.problem.empty() && !fit.problem.empty() && !w.constant) w.prepend(fit.problem);
  w.method = "sparse polynomial chaos, jackknife over ten folds";
  w.put_all("total_order", fit.total, fit.used, fit.dropped, fit.used);
  w.put_all("first_order", fit.first, fit.used, fit.dropped, fit.used);
  w.put_fit(fit.q2, fit.degree, fit.terms, fit.used, fit.dropped);
}

}  // namespace cpt::results

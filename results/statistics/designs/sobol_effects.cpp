#include <fmt/format.h>

#include <cmath>
#include <string>

#include "parameters/designs/sobol.hpp"
#include "parameters/designs/variation.hpp"
#include "results/statistics/window_effects.hpp"

namespace cpt::results {

namespace {

using parameters::SobolEstimator;

std::string interval_words(const parameters::Design& design) {
  return design.sections > 1 ? fmt::format("{} sections", design.sections) : "bootstrap over rows";
}

}  // namespace

void add_sobol_effects(WindowEffects& w) {
  const parameters::Design& design = w.study.design;
  const int width = parameters::width_of(design);
  const SobolEstimator estimator = parameters::sobol_estimator(design.estimator);
  const auto indices = parameters::sobol_indices(width, w.y, design.seed, estimator, design.sections);
  // A and B alone may not vary.
  if (!w.constant && indices.used > 1 && std::isnan(indices.total.front().value))
    w.prepend(parameters::does_not_vary);
  const bool martinez = estimator == SobolEstimator::martinez;
  const auto put = [&](std::string_view quantity, const auto& estimates, std::string_view source) {
    w.method = fmt::format("{}, {}", source, interval_words(design));
    w.put_all(quantity, estimates, indices.used, indices.dropped, indices.used * (width + 2));
  };
  put("total_order", indices.total, martinez ? "Martinez" : "Jansen");
  put("first_order", indices.first, martinez ? "Martinez" : "Saltelli");
}

}  // namespace cpt::results

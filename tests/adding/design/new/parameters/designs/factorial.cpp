#include "parameters/designs/factorial.hpp"

#include <fmt/format.h>

namespace cpt::parameters {

using Eigen::Index;

Eigen::MatrixXd factorial_places(int parameters) {
  const Index runs = Index{1} << parameters;
  Eigen::MatrixXd places(runs, parameters);
  for (Index run = 0; run < runs; ++run)
    for (Index j = 0; j < parameters; ++j) places(run, j) = static_cast<double>((run >> j) & 1);
  return places;
}

double main_effect(const Eigen::MatrixXd& places, const Eigen::VectorXd& y, Index parameter) {
  return (2.0 * places.col(parameter).array() - 1.0).matrix().dot(y) / (0.5 * static_cast<double>(y.size()));
}

DesignKind factorial_design() {
  return {.name = "factorial",
          .usual_rows = 5,
          .run_count =
              [](const Design& design) {
                return width_of(design) < 62 ? 1L << width_of(design) : std::numeric_limits<long>::max();
              },
          .places = [](const Design& design) { return factorial_places(width_of(design)); },
          .run_name = [](const Design&, Index run) { return fmt::format("factorial {}", run + 1); }};
}

}  // namespace cpt::parameters

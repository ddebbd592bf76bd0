#include "parameters/designs/pairs.hpp"

#include <cmath>
#include <limits>

#include "parameters/designs/variation.hpp"

namespace cpt::parameters {

using Eigen::Index;

std::vector<std::pair<Index, Index>> pairs_of(int parameters) {
  std::vector<std::pair<Index, Index>> pairs;
  for (Index i = 0; i < parameters; ++i)
    for (Index j = i + 1; j < parameters; ++j) pairs.emplace_back(i, j);
  return pairs;
}

Eigen::MatrixXd pairs_places(int parameters) {
  const auto pairs = pairs_of(parameters);
  Eigen::MatrixXd places = Eigen::MatrixXd::Constant(4 * static_cast<Index>(pairs.size()), parameters,
                                                     std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    for (Index corner = 0; corner < 4; ++corner) {
      places(4 * static_cast<Index>(k) + corner, pairs[k].first) = static_cast<double>(corner % 2);
      places(4 * static_cast<Index>(k) + corner, pairs[k].second) = static_cast<double>(corner / 2);
    }
  return places;
}

double interaction(const std::array<double, 4>& y) {
  const double interaction = 0.5 * ((y[3] - y[2]) - (y[1] - y[0]));
  return std::isnan(interaction) || differ(y[3] + y[0], y[1] + y[2]) ? interaction : 0.0;
}

Estimate interaction_estimate(const std::array<double, 4>& y, double scatter) {
  const double value = interaction(y), half = 0.5 * Eigen::Vector4d(y.data()).norm() * scatter;
  return {value, value - half, value + half};
}

DesignKind pairs_design() {
  return {.name = "pairs",
          .least_rows = 2,
          .usual_rows = 4,  // all pairs of a long table cost more than they tell
          .run_count = [](const Design& design) { return 2L * width_of(design) * (width_of(design) - 1); },
          .places = [](const Design& design) { return pairs_places(width_of(design)); },
          .run_name = [](const Design&, Index run) { return name_in_group("pairs", run, 4); }};
}

}  // namespace cpt::parameters

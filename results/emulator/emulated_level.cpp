#include "results/emulator/emulated_level.hpp"

#include <cmath>
#include <vector>

#include "parameters/designs/propagation.hpp"
#include "parameters/designs/sparse_expansion.hpp"
#include "parameters/designs/variation.hpp"
#include "results/emulator/placed_inputs.hpp"

namespace cpt::results {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

EmulatedLevel emulated_level(const parameters::Study& study, const VectorXd& y, Index runs) {
  const PlacedInputs inputs(study);
  const MatrixXd places = inputs.places(runs);
  const parameters::ExpansionTerms candidates(inputs.values(), static_cast<std::size_t>(y.size()));
  const MatrixXd at_runs = candidates.at(places.topRows(y.size()));
  EmulatedLevel level{VectorXd(runs), parameters::undefined};
  double squares = 0.0, sum = 0.0, sum_of_squares = 0.0, count = 0.0;
  for (int section = 0; section < parameters::propagation_sections; ++section) {
    const auto own = [&](Index run) { return parameters::section_of(run, study.design.latin) == section; };
    std::vector<Index> known, asked;
    for (Index run = 0; run < y.size(); ++run)
      if (!own(run) && std::isfinite(y(run))) known.push_back(run);
    for (Index run = 0; run < runs; ++run)
      if (own(run)) asked.push_back(run);
    const MatrixXd at_known = at_runs(known, Eigen::all);
    if (known.size() < parameters::runs_per_term * (inputs.count() + 1) || !candidates.told_apart(at_known))
      return {{}, parameters::undefined};
    const VectorXd results = y(known);
    const double mean = results.mean();
    const auto expansion = candidates.expand(at_known, (results.array() - mean).matrix());
    const VectorXd told =
        expansion.columns.empty()
            ? VectorXd::Zero(static_cast<Index>(asked.size())).eval()
            : (candidates.at(places(asked, Eigen::all), expansion.terms) * expansion.coefficients).eval();
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const Index run = asked[k];
      level.y(run) = mean + told(static_cast<Index>(k));
      if (run >= y.size() || !std::isfinite(y(run))) continue;
      squares += std::pow(y(run) - level.y(run), 2);
      sum += y(run);
      sum_of_squares += y(run) * y(run);
      count += 1.0;
    }
  }
  level.q2 = 1.0 - squares / (sum_of_squares - sum * sum / count);
  return level;
}

}  // namespace cpt::results

#include "cli/emulator/next_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "parameters/designs/design.hpp"
#include "parameters/designs/propagation.hpp"
#include "parameters/distributions/copula.hpp"
#include "parameters/read_samples.hpp"
#include "solver/quantities.hpp"

namespace cpt::cli {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr int candidates = 2048;

std::vector<std::size_t> rows_of(const parameters::Study& study, const results::Emulator& emulator) {
  std::vector<std::size_t> rows;
  for (const results::EmulatorInput& input : emulator.inputs)
    rows.push_back(static_cast<std::size_t>(
        std::ranges::find(study.rows, input.name, [](const auto& row) { return row.quantity->name; }) -
        study.rows.begin()));
  return rows;
}

double with_four_digits(double value) { return std::stod(fmt::format("{:.4g}", value)); }

// Candidates in study units, those that no push can have left out.
MatrixXd candidate_values(const parameters::Study& study, const results::Emulator& emulator,
                          const std::vector<std::size_t>& rows) {
  parameters::Design design = study.design;
  design.rows = rows;
  const auto inputs = static_cast<int>(rows.size());
  MatrixXd places = parameters::propagation_places(inputs, candidates, study.design.seed);
  if (!study.correlations.empty())
    places = parameters::dependent_places(places, parameters::score_correlations(study.correlations, design));
  MatrixXd values(places.rows(), places.cols());
  Index kept = 0;
  for (Index i = 0; i < places.rows(); ++i) {
    solver::Setup setup = study.baseline;
    for (Index j = 0; j < places.cols(); ++j) {
      const parameters::Row& row = study.rows[rows[static_cast<std::size_t>(j)]];
      const results::EmulatorInput& input = emulator.inputs[static_cast<std::size_t>(j)];
      const double value = with_four_digits(parameters::value_of_probability(row, places(i, j)));
      values(kept, j) = input.integer || !input.choices.empty()
                            ? parameters::value_of_probability(row, places(i, j))
                            : std::clamp(value, input.lower, input.upper);
      row.quantity->set_value(setup, values(kept, j));
    }
    if (solver::problems(setup).empty()) ++kept;
  }
  return values.topRows(kept);
}

}  // namespace

std::string next_points(const parameters::Study& study, const results::Emulator& emulator, int count) {
  const std::vector<std::size_t> rows = rows_of(study, emulator);
  const MatrixXd values = candidate_values(study, emulator, rows);
  std::set<std::string> names;
  for (const parameters::DesignPoint& point : study.points) names.insert(point.name);
  std::vector<parameters::Sample> points;
  int number = 0;
  for (const Index at : results::worst_places(emulator, emulator.places(values), count)) {
    parameters::Sample& point = points.emplace_back();
    do point.name = fmt::format("emulator {}", ++number);
    while (names.contains(point.name));
    for (std::size_t j = 0; j < rows.size(); ++j)
      point.changes.push_back({study.rows[rows[j]].quantity, values(at, static_cast<Index>(j))});
  }
  return parameters::with_points("", points);
}

}  // namespace cpt::cli

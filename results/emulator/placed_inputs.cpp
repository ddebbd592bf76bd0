#include "results/emulator/placed_inputs.hpp"

#include <algorithm>

#include "parameters/designs/design.hpp"

namespace cpt::results {

using Eigen::Index;
using Eigen::MatrixXd;

PlacedInputs::Placed::Placed(const parameters::Row& of) : row(&of), value(of) {
  constexpr double most_score = 3.3;
  least = value(-most_score);
  most = value(most_score);
}

double PlacedInputs::Placed::place(double at) const {
  return std::clamp((at - least) / (most - least), 0.0, 1.0);
}

PlacedInputs::PlacedInputs(const parameters::Study& study) : study_(study) {
  for (const std::size_t row : study.design.rows)
    if (!study.rows[row].only_drawn()) rows_.emplace_back(study.rows[row]);
}

std::vector<int> PlacedInputs::values() const {
  std::vector<int> values;
  for (const Placed& one : rows_) values.push_back(one.row->marginal ? 0 : parameters::values_of(*one.row));
  return values;
}

std::vector<parameters::ScoredInput> PlacedInputs::scored() const {
  std::vector<parameters::ScoredInput> inputs;
  const std::vector<int> taken = values();
  for (std::size_t j = 0; j < rows_.size(); ++j)
    inputs.push_back({taken[j], [one = &rows_[j]](double score) { return one->place(one->value(score)); }});
  return inputs;
}

MatrixXd PlacedInputs::correlation() const {
  const auto inputs = static_cast<Index>(rows_.size());  // what every run draws comes last
  return parameters::score_correlations(study_.correlations, study_.design).topLeftCorner(inputs, inputs);
}

MatrixXd PlacedInputs::places(Index runs) const {
  parameters::Study study = study_;
  study.design.runs = static_cast<int>(runs);
  MatrixXd places = parameters::design_places(study).topLeftCorner(runs, static_cast<Index>(rows_.size()));
  for (std::size_t j = 0; j < rows_.size(); ++j)
    for (double& place : places.col(static_cast<Index>(j)))
      place = rows_[j].place(parameters::value_of_probability(*rows_[j].row, place));
  return places;
}

}  // namespace cpt::results

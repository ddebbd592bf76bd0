#include "results/emulator/validation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

Validation judged(const MatrixXd& outputs, const MatrixXd& value, const MatrixXd& lower,
                  const MatrixXd& upper) {
  Validation result;
  result.runs = static_cast<int>(outputs.cols());
  result.q2 = predictivity(outputs, value);
  result.rmse = std::sqrt((outputs - value).squaredNorm() / static_cast<double>(outputs.size()));
  const auto within = outputs.array() >= lower.array() && outputs.array() <= upper.array();
  result.coverage = static_cast<double>(within.count()) / static_cast<double>(outputs.size());
  const Share interval = wilson(result.coverage, result.runs);
  result.coverage_lower = interval.lower;
  result.coverage_upper = interval.upper;
  return result;
}

}  // namespace

double predictivity(const MatrixXd& outputs, const MatrixXd& predicted) {
  const double deviations = (outputs.colwise() - outputs.rowwise().mean()).squaredNorm();
  return 1.0 - (outputs - predicted).squaredNorm() / deviations;
}

Share wilson(double share, int trials) {
  const double n = trials, z2 = normal_95 * normal_95;
  const double centre = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = normal_95 / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

Validation cross_validation(const MatrixXd& design, const MatrixXd& outputs, bool logarithmic,
                            const OutputEmulator::Options& options) {
  const Index runs = design.rows(), folds = std::min<Index>(validation_folds, runs);
  MatrixXd value(outputs.rows(), runs), lower = value, upper = value;
  for (Index fold = 0; fold < folds; ++fold) {
    std::vector<Index> held, kept;
    for (Index run = 0; run < runs; ++run) (run % folds == fold ? held : kept).push_back(run);
    const OutputEmulator emulator =
        OutputEmulator::fit(design(kept, Eigen::all), outputs(Eigen::all, kept), logarithmic, options);
    const OutputPrediction at = emulator.predict(design(held, Eigen::all));
    value(Eigen::all, held) = at.value;
    lower(Eigen::all, held) = at.lower;
    upper(Eigen::all, held) = at.upper;
  }
  return judged(outputs, value, lower, upper);
}

Validation validation_at(const OutputEmulator& emulator, const MatrixXd& design, const MatrixXd& outputs) {
  const OutputPrediction at = emulator.predict(design);
  return judged(outputs, at.value, at.lower, at.upper);
}

}  // namespace cpt::results

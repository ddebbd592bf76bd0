#include "reports/calibration/posterior_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/calibration/posterior_distribution.hpp"

namespace cpt::reports::calibrated {
namespace {

using Eigen::Index;

// A comment is one line.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

std::string discrete_text(const ReportedInput& input, const diagnosis::FittedDistribution& fitted) {
  std::vector<std::string> values, weights;
  for (std::size_t k = 0; k < fitted.values.size(); ++k) {
    values.push_back(input.choices.empty()
                         ? fmt::format("{}", fitted.values[k])
                         : fmt::format("\"{}\"", input.choices[fitted.values[k] == input.lower ? 0 : 1]));
    weights.push_back(fmt::format("{:.4g}", fitted.weights[k]));
  }
  return fmt::format("kind = \"discrete\", values = [{}], weights = [{}]", fmt::join(values, ", "),
                     fmt::join(weights, ", "));
}

std::string row_of(const ReportedInput& input, const Eigen::VectorXd& draws) {
  const auto fitted = diagnosis::fitted_distribution(draws, input.lower, input.upper, input.discrete);
  if (input.discrete)
    return fmt::format("\"{}\" = {{ distribution = {{ {} }} }}\n", input.name, discrete_text(input, fitted));
  return fmt::format(
      "\"{}\" = {{ distribution = {{ kind = \"{}\", mean = {:.6g}, standard_deviation = {:.6g}, min = {}, "
      "max = {} }} "
      "}}  # quantiles within {:.2f} standard deviations\n",
      input.name, parameters::to_string(fitted.family), fitted.mean, fitted.deviation, fitted.least,
      fitted.most, fitted.apart);
}

}  // namespace

std::string posterior_study(const CalibrationReport& report) {
  std::string text = fmt::format(
      "# {}: what the recordings leave of the inputs of {}. Paste into a study in place of its own\n"
      "# [parameters], [correlation] and [design]. Kinds are those whose quantiles are nearest to the "
      "draws'.\n\n"
      "[design]\nkind = \"propagation\"\nruns = 100\n{}\n[parameters]\n",
      on_one_line(report.title), on_one_line(report.study),
      report.shifts_points ? "shift_points = true\n" : "");
  for (std::size_t j = 0; j < report.inputs.size(); ++j)
    text += row_of(report.inputs[j], report.posterior.draws.col(static_cast<Index>(j)));
  const Eigen::MatrixXd ranks =
      diagnosis::copula_rank_correlations(report.posterior.correlation.topLeftCorner(
          static_cast<Index>(report.inputs.size()), static_cast<Index>(report.inputs.size())));
  std::string correlation;
  for (Index a = 0; a < ranks.rows(); ++a) {
    std::vector<std::string> pairs;
    for (Index b = a + 1; b < ranks.cols(); ++b)
      if (std::abs(ranks(a, b)) >= 0.005)
        pairs.push_back(
            fmt::format("\"{}\" = {:.4g}", report.inputs[static_cast<std::size_t>(b)].name, ranks(a, b)));
    if (!pairs.empty())
      correlation += fmt::format("\"{}\" = {{ {} }}\n", report.inputs[static_cast<std::size_t>(a)].name,
                                 fmt::join(pairs, ", "));
  }
  if (!correlation.empty()) text += "\n[correlation]\n" + correlation;
  return text;
}

}  // namespace cpt::reports::calibrated

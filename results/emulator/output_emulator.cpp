#include "results/emulator/output_emulator.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "results/emulator/validation.hpp"

namespace cpt::results {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

OutputEmulator OutputEmulator::fit(const MatrixXd& design, const MatrixXd& outputs, bool logarithmic,
                                   const Options& options) {
  if (outputs.rows() < 1 || outputs.cols() != design.rows() || !outputs.allFinite())
    throw std::invalid_argument("runs and outputs do not agree, or outputs are not finite");
  if (logarithmic && !(outputs.array() > 0.0).all())
    throw std::invalid_argument("the logarithm is taken of positive outputs only");
  const MatrixXd curves = logarithmic ? MatrixXd(outputs.array().log()) : outputs;
  PrincipalComponents components =
      principal_components(curves, options.variance_left, options.most_components);
  const MatrixXd wanted = scores(components, curves);
  const Trend trend = trend_for(design.rows(), design.cols());
  std::vector<GaussianProcess> processes;
  for (Index c = 0; c < wanted.rows(); ++c)
    processes.push_back(GaussianProcess::fit(design, wanted.row(c).transpose(), trend, options.search));
  return {std::move(components), std::move(processes), logarithmic};
}

OutputEmulator OutputEmulator::fit(const MatrixXd& design, const MatrixXd& outputs, bool logarithmic) {
  return fit(design, outputs, logarithmic, Options{});
}

OutputEmulator OutputEmulator::fit(const MatrixXd& design, const MatrixXd& outputs) {
  OutputEmulator plain = fit(design, outputs, false);
  if (!(outputs.array() > 0.0).all()) return plain;
  OutputEmulator logarithmic = fit(design, outputs, true);
  return logarithmic.left_out_q2(outputs) > plain.left_out_q2(outputs) ? logarithmic : plain;
}

OutputEmulator::OutputEmulator(PrincipalComponents components, std::vector<GaussianProcess> processes,
                               bool logarithmic)
    : components_(std::move(components)), processes_(std::move(processes)), logarithmic_(logarithmic) {
  if (processes_.empty()) throw std::invalid_argument("the output does not vary");
  if (components_.shapes.cols() != static_cast<Index>(processes_.size()) ||
      components_.shapes.rows() != components_.mean.size() ||
      components_.left_out.size() != components_.mean.size() ||
      components_.left_out_correlation.size() != components_.mean.size() || !components_.mean.allFinite() ||
      !components_.shapes.allFinite() || !components_.left_out.allFinite() ||
      !components_.left_out_correlation.allFinite() || !(components_.left_out.array() >= 0.0).all())
    throw std::invalid_argument("components and processes do not agree");
  for (const GaussianProcess& process : processes_)
    if (process.inputs() != inputs() || process.runs() != processes_.front().runs())
      throw std::invalid_argument("the processes are not of the same runs");
}

MatrixXd OutputEmulator::score_means(const MatrixXd& points) const {
  MatrixXd means(components_.shapes.cols(), points.rows());
  for (Index c = 0; c < means.rows(); ++c)
    means.row(c) = processes_[static_cast<std::size_t>(c)].mean(points).transpose();
  return means;
}

MatrixXd OutputEmulator::score_variances(const MatrixXd& points) const {
  MatrixXd variances(components_.shapes.cols(), points.rows());
  for (Index c = 0; c < variances.rows(); ++c)
    variances.row(c) = processes_[static_cast<std::size_t>(c)].mean_variance(points).transpose();
  return variances;
}

OutputEmulator::ScoresAtPoint OutputEmulator::scores_at(const Eigen::RowVectorXd& point) const {
  ScoresAtPoint found{VectorXd(components_.shapes.cols()), VectorXd(components_.shapes.cols())};
  for (Index c = 0; c < found.mean.size(); ++c) {
    const GaussianProcess& process = processes_[static_cast<std::size_t>(c)];
    const GaussianProcess::AtPoint here = process.at(point);
    found.mean(c) = here.mean;
    found.variance(c) = here.variance + process.noise();
  }
  return found;
}

VectorXd OutputEmulator::noise() const {
  VectorXd of_scores(components_.shapes.cols());
  for (Index c = 0; c < of_scores.size(); ++c) of_scores(c) = processes_[static_cast<std::size_t>(c)].noise();
  return components_.shapes.cwiseAbs2() * of_scores + components_.left_out;
}

OutputPrediction OutputEmulator::predict(const MatrixXd& points) const {
  if (points.cols() != inputs()) throw std::invalid_argument("a point has another number of inputs");
  const MatrixXd mean = (components_.shapes * score_means(points)).colwise() + components_.mean;
  const MatrixXd variance = (components_.shapes.cwiseAbs2() * score_variances(points)).colwise() + noise();
  const Eigen::ArrayXXd deviation = variance.array().sqrt();
  OutputPrediction at;
  at.lower = mean.array() - normal_95 * deviation;
  at.upper = mean.array() + normal_95 * deviation;
  if (!logarithmic_) {
    at.value = mean;
    at.error = deviation;
    return at;
  }
  // Moments of the lognormal distribution.
  at.value = (mean.array() + 0.5 * variance.array()).exp();
  at.error = at.value.array() * (variance.array().exp() - 1.0).sqrt();
  at.lower = at.lower.array().exp();
  at.upper = at.upper.array().exp();
  return at;
}

double OutputEmulator::left_out_q2(const MatrixXd& outputs) const {
  const MatrixXd curves = logarithmic_ ? MatrixXd(outputs.array().log()) : outputs;
  MatrixXd predicted = scores(components_, curves);
  for (Index c = 0; c < predicted.rows(); ++c)
    predicted.row(c) -= processes_[static_cast<std::size_t>(c)].left_out_errors().transpose();
  MatrixXd values = (components_.shapes * predicted).colwise() + components_.mean;
  if (logarithmic_) values = values.array().exp();
  return predictivity(outputs, values);
}

}  // namespace cpt::results

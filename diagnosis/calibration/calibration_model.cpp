#include "diagnosis/calibration/calibration_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "diagnosis/covariance.hpp"

namespace cpt::diagnosis {

double half_normal_value(double scale, double score) {
  constexpr double edge = 1e-300;
  const double above = 0.5 * std::erfc(score / std::numbers::sqrt2);  // of the normal score
  return scale * std::numbers::sqrt2 * boost::math::erfc_inv(std::max(above, edge));
}

CalibrationModel::CalibrationModel(CalibrationProblem problem) : problem_(std::move(problem)) {
  const auto inputs = static_cast<Index>(problem_.inputs.size());
  if (inputs == 0 || problem_.correlation.rows() != inputs || problem_.correlation.cols() != inputs)
    throw std::invalid_argument("inputs and their correlation do not agree");
  factor_ = problem_.correlation.llt().matrixL();
  for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
    const CalibrationChannel& channel = problem_.channels[c];
    const auto n = static_cast<Index>(channel.cells.size());
    if (n == 0 || channel.recorded.size() != n || channel.mean.size() != n || channel.shapes.rows() != n ||
        channel.left_out.rows() != n || channel.left_out.cols() != n)
      throw std::invalid_argument("cells and curves do not agree");
    constexpr double least_share = 0.1;  // of the largest value: where a curve is nil, deviations are not
    units_.push_back(channel.logarithmic ? VectorXd::Ones(n)
                                         : VectorXd(channel.mean.cwiseAbs().cwiseMax(
                                               least_share * channel.mean.cwiseAbs().maxCoeff())));
    std::vector<Block>& blocks = blocks_.emplace_back();
    for (Index first = 0, last = 0; first < n; first = last) {
      const int sounding = channel.cells[static_cast<std::size_t>(first)].sounding;
      while (last < n && channel.cells[static_cast<std::size_t>(last)].sounding == sounding) ++last;
      const std::vector<Cell> own(channel.cells.begin() + first, channel.cells.begin() + last);
      const auto unit = units_.back().segment(first, last - first).asDiagonal();
      blocks.push_back({first, last - first, sounding,
                        unit * noise_covariance(own, {Kernel::matern_32, 1.0, channel.length}) * unit,
                        channel.left_out.block(first, first, last - first, last - first)});
      deviations_.push_back({true, c, sounding, channel.discrepancy});
    }
  }
  for (std::size_t c = 0; c < problem_.channels.size(); ++c)
    if (!problem_.channels[c].noise_is_known)
      deviations_.push_back({false, c, 0, problem_.channels[c].noise});
}

std::vector<std::string> CalibrationModel::names() const {
  std::vector<std::string> names;
  for (const CalibrationInput& input : problem_.inputs) names.push_back(input.name);
  for (const CalibrationDeviation& deviation : deviations_) {
    const std::string& channel = problem_.channels[deviation.channel].name;
    const bool several = problem_.soundings.size() > 1;
    names.push_back(
        deviation.of_discrepancy
            ? fmt::format("discrepancy {}{}{}", channel, several ? " " : "",
                          several ? problem_.soundings[static_cast<std::size_t>(deviation.sounding)] : "")
            : fmt::format("noise {}", channel));
  }
  return names;
}

VectorXd CalibrationModel::values(const VectorXd& scores) const {
  VectorXd values(scores.size());
  const std::size_t inputs = problem_.inputs.size();
  for (std::size_t j = 0; j < inputs; ++j)
    values(static_cast<Index>(j)) = problem_.inputs[j].value(scores(static_cast<Index>(j)));
  for (std::size_t k = 0; k < deviations_.size(); ++k) {
    const auto at = static_cast<Index>(inputs + k);
    values(at) = half_normal_value(deviations_[k].scale, scores(at));
  }
  return values;
}

bool CalibrationModel::within(const VectorXd& values) const {
  for (std::size_t j = 0; j < problem_.inputs.size(); ++j) {
    const double value = values(static_cast<Index>(j));
    if (!(value >= problem_.inputs[j].lower && value <= problem_.inputs[j].upper)) return false;
  }
  return true;
}

double CalibrationModel::log_prior(const VectorXd& scores) const {
  const auto inputs = static_cast<Index>(problem_.inputs.size());
  const VectorXd independent = factor_.triangularView<Eigen::Lower>().solve(scores.head(inputs));
  return -0.5 * (independent.squaredNorm() + scores.tail(scores.size() - inputs).squaredNorm());
}

Eigen::RowVectorXd CalibrationModel::place_of(const VectorXd& values) const {
  Eigen::RowVectorXd place(static_cast<Index>(problem_.inputs.size()));
  for (Index j = 0; j < place.size(); ++j)
    place(j) = problem_.inputs[static_cast<std::size_t>(j)].place(values(j));
  return place;
}

double CalibrationModel::noise_of(std::size_t channel, const VectorXd& values) const {
  for (std::size_t k = 0; k < deviations_.size(); ++k)
    if (!deviations_[k].of_discrepancy && deviations_[k].channel == channel)
      return values(static_cast<Index>(problem_.inputs.size() + k));
  return problem_.channels[channel].noise;
}

double CalibrationModel::discrepancy_of(std::size_t channel, int sounding, const VectorXd& values) const {
  for (std::size_t k = 0; k < deviations_.size(); ++k)
    if (deviations_[k].of_discrepancy && deviations_[k].channel == channel &&
        deviations_[k].sounding == sounding)
      return values(static_cast<Index>(problem_.inputs.size() + k));
  throw std::logic_error("a sounding without discrepancy");
}

double CalibrationModel::log_likelihood(const VectorXd& values) const {
  const Eigen::RowVectorXd place = place_of(values);
  double sum = 0.0;
  for (std::size_t c = 0; c < problem_.channels.size(); ++c) sum += channel_likelihood(c, place, values);
  return sum;
}

// Covariance A + S V S^T, A of each sounding for itself, V of the scores: Woodbury's identity, with I + V^1/2
// S^T A^-1 S V^1/2, which needs no inverse of V.
double CalibrationModel::channel_likelihood(std::size_t c, const Eigen::RowVectorXd& place,
                                            const VectorXd& values) const {
  const CalibrationChannel& channel = problem_.channels[c];
  const ScorePrediction scores = channel.scores(place);
  const MatrixXd scaled = channel.shapes * scores.variance.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const VectorXd residual = channel.recorded - channel.mean - channel.shapes * scores.mean;
  const double noise = noise_of(c, values);
  MatrixXd inner = MatrixXd::Identity(scaled.cols(), scaled.cols());
  VectorXd projected = VectorXd::Zero(scaled.cols());
  double square = 0.0, log_determinant = 0.0;
  for (const Block& block : blocks_[c]) {
    const double deviation = discrepancy_of(c, block.sounding, values);
    MatrixXd covariance = deviation * deviation * block.correlation + block.left_out;
    covariance.diagonal() += (noise * units_[c].segment(block.first, block.count)).cwiseAbs2();
    const Whitener whitener(covariance);
    const VectorXd white = whitener.whiten(residual.segment(block.first, block.count));
    const MatrixXd shapes = whitener.whiten(scaled.middleRows(block.first, block.count));
    inner += shapes.transpose() * shapes;
    projected += shapes.transpose() * white;
    square += white.squaredNorm();
    log_determinant += whitener.log_determinant();
  }
  const Eigen::LLT<MatrixXd> factor(inner);
  log_determinant += 2.0 * factor.matrixLLT().diagonal().array().log().sum();
  square -= factor.matrixL().solve(projected).squaredNorm();
  const auto n = static_cast<double>(residual.size());
  return -0.5 * (n * std::log(2.0 * std::numbers::pi) + log_determinant + square);
}

double CalibrationModel::log_posterior(const VectorXd& scores) const {
  constexpr double nil = -std::numeric_limits<double>::infinity();
  const VectorXd at = values(scores);
  if (!within(at)) return nil;
  try {
    return log_prior(scores) + log_likelihood(at);
  } catch (const std::invalid_argument&) {  // no positive definite covariance: no noise at all
    return nil;
  }
}

VectorXd CalibrationModel::draw_prior(Random& random) const {
  const auto inputs = static_cast<Index>(problem_.inputs.size());
  for (;;) {
    VectorXd scores = random.normals(unknowns());
    scores.head(inputs) = (factor_ * scores.head(inputs)).eval();
    if (within(values(scores))) return scores;
  }
}

CalibratedCells CalibrationModel::cells(std::size_t c, const VectorXd& values) const {
  const CalibrationChannel& channel = problem_.channels[c];
  const ScorePrediction scores = channel.scores(place_of(values));
  const MatrixXd scaled = channel.shapes * scores.variance.cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const double noise = noise_of(c, values);
  const auto n = static_cast<Index>(channel.cells.size());
  CalibratedCells found;
  found.simulation = channel.mean + channel.shapes * scores.mean;
  found.simulation_variance = scaled.rowwise().squaredNorm() + channel.left_out.diagonal();
  MatrixXd covariance = scaled * scaled.transpose(), discrepancy = MatrixXd::Zero(n, n);
  for (const Block& block : blocks_[c]) {
    const double deviation = discrepancy_of(c, block.sounding, values);
    discrepancy.block(block.first, block.first, block.count, block.count) =
        deviation * deviation * block.correlation;
    covariance.block(block.first, block.first, block.count, block.count) += block.left_out;
  }
  const VectorXd measured = (noise * units_[c]).cwiseAbs2();
  covariance += discrepancy;
  covariance.diagonal() += measured;
  const Whitener whitener(covariance);
  found.discrepancy = discrepancy * whitener.solve(channel.recorded - found.simulation);
  found.discrepancy_variance =
      (discrepancy.diagonal() - whitener.whiten(discrepancy).colwise().squaredNorm().transpose())
          .cwiseMax(0.0);
  found.other_variance = discrepancy.diagonal() + measured;
  return found;
}

VectorXd CalibrationModel::draw_recording(std::size_t c, const VectorXd& curve, const VectorXd& values,
                                          Random& random) const {
  VectorXd recorded = curve;
  const double noise = noise_of(c, values);
  for (const Block& block : blocks_[c]) {
    const double deviation = discrepancy_of(c, block.sounding, values);
    recorded.segment(block.first, block.count) +=
        deviation * Whitener(block.correlation).colour(random.normals(block.count));
  }
  return recorded + noise * units_[c].cwiseProduct(random.normals(curve.size()));
}

CalibrationModel CalibrationModel::with_recordings(const std::vector<VectorXd>& recorded) const {
  CalibrationProblem other = problem_;
  for (std::size_t c = 0; c < other.channels.size(); ++c) other.channels[c].recorded = recorded.at(c);
  return CalibrationModel(std::move(other));
}

}  // namespace cpt::diagnosis

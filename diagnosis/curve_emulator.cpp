#include "diagnosis/curve_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "diagnosis/covariance.hpp"

namespace cpt::diagnosis {
namespace {

void check(const MechanismEffect& effect) {
  const auto dimensions = static_cast<Index>(effect.parameters.size());
  const MatrixXd& design = effect.design;
  if (dimensions < 1 || dimensions > 3 || design.cols() != dimensions || design.rows() != effect.delta.cols())
    throw std::invalid_argument(effect.name + ": design, parameters and curves do not agree");
  if (design.rows() < 4 * dimensions)
    throw std::invalid_argument(effect.name + ": fewer than 4 runs for each parameter");
  if (!(design.array() >= 0.0 && design.array() <= 1.0).all() || !effect.delta.allFinite())
    throw std::invalid_argument(effect.name + ": a design outside the unit cube, or curves with gaps");
  const Index joint = effect.joint_delta.cols();
  if (joint > 0 && (effect.joint_design.rows() != joint || effect.joint_design.cols() != dimensions ||
                    effect.joint_delta.rows() != effect.delta.rows() || !effect.joint_delta.allFinite()))
    throw std::invalid_argument(effect.name + ": joint runs that do not agree, or with gaps");
}

// Where the first coordinate is 0: a grid of three places in each of the others.
MatrixXd anchors(Index dimensions) {
  Index count = 1;
  for (Index d = 1; d < dimensions; ++d) count *= 3;
  MatrixXd points = MatrixXd::Zero(count, dimensions);
  for (Index i = 0; i < count; ++i)
    for (Index d = 1, rest = i; d < dimensions; ++d, rest /= 3)
      points(i, d) = 0.5 * static_cast<double>(rest % 3);
  return points;
}

MatrixXd polynomial(const MatrixXd& points, bool quadratic) {
  const Index d = points.cols();
  MatrixXd terms(points.rows(), 1 + d + (quadratic ? d * (d + 1) / 2 : 0));
  terms.col(0).setOnes();
  terms.middleCols(1, d) = points;
  Index column = 1 + d;
  for (Index i = 0; quadratic && i < d; ++i)
    for (Index j = i; j < d; ++j) terms.col(column++) = points.col(i).cwiseProduct(points.col(j));
  return terms;
}

// Matern-5/2 with a length for each dimension.
MatrixXd kernel(const MatrixXd& a, const MatrixXd& b, const VectorXd& lengths) {
  const VectorXd per_length = std::sqrt(5.0) * lengths.cwiseInverse();
  const MatrixXd x = per_length.asDiagonal() * a.transpose(), y = per_length.asDiagonal() * b.transpose();
  MatrixXd k(a.rows(), b.rows());
  for (Index j = 0; j < k.cols(); ++j)
    for (Index i = 0; i < k.rows(); ++i) {
      double squares = 0.0;
      for (Index d = 0; d < x.rows(); ++d) squares += (x(d, i) - y(d, j)) * (x(d, i) - y(d, j));
      const double r = std::sqrt(squares);
      k(i, j) = (1.0 + r + squares / 3.0) * std::exp(-r);
    }
  return k;
}

}  // namespace

CurveEmulator::CurveEmulator(const MechanismEffect& effect) : CurveEmulator(effect, Options{}) {}

CurveEmulator::CurveEmulator(const MechanismEffect& effect, const Options& options)
    : name_(effect.name),
      parameters_(effect.parameters),
      vanishes_at_zero_(effect.vanishes_at_zero),
      runs_(effect.design.rows()) {
  check(effect);
  const MatrixXd zero = vanishes_at_zero_ ? anchors(dimensions()) : MatrixXd(0, dimensions());
  design_.resize(runs_ + zero.rows(), dimensions());
  design_ << effect.design, zero;
  quadratic_ = runs_ >= (dimensions() + 1) * (dimensions() + 2);  // twice as many runs as terms
  trend_ = polynomial(design_, quadratic_);

  // No mean is taken off: the zero curve must have zero scores.
  const Eigen::JacobiSVD<MatrixXd> svd(effect.delta, Eigen::ComputeThinU);
  const VectorXd power = svd.singularValues().cwiseAbs2();
  Index kept = 0;
  for (double rest = power.sum(); kept < std::min<Index>(options.most_components, power.size()) &&
                                  rest > options.variance_left * power.sum();)
    rest -= power(kept++);
  components_ = svd.matrixU().leftCols(kept);
  const MatrixXd values = components_.transpose() * effect.delta;  // c x runs

  left_out_ = effect.delta - components_ * values;
  processes_.resize(static_cast<std::size_t>(kept));
  for (Index c = 0; c < kept; ++c) {
    VectorXd y = VectorXd::Zero(design_.rows());
    y.head(runs_) = values.row(c).transpose();
    Process& process = processes_[static_cast<std::size_t>(c)];
    fit(y, process);
    const VectorXd errors = process.weights.head(runs_).cwiseQuotient(process.inverse.diagonal().head(runs_));
    left_out_ += components_.col(c) * errors.transpose();
    left_out_variance_ += process.variance * process.inverse.diagonal().head(runs_).cwiseInverse().mean();
  }
  error_ = low_rank_plus_diagonal(left_out_, options.error_rank);
  if (effect.joint_delta.cols() > 0) {
    const MatrixXd joint = scores(effect.joint_design);
    joint_left_ = effect.joint_delta - components_ * joint;
    const MatrixXd interaction = low_rank_plus_diagonal(joint_left_, options.error_rank);
    joint_power_ = joint.squaredNorm() / static_cast<double>(joint.cols());
    if (joint_power_ > 0.0) {
      left_out_share_ = error_.trace() / (error_.trace() + interaction.trace());
      error_ += interaction;
    }
  }
}

bool CurveEmulator::factor(const VectorXd& lengths, double nugget, const VectorXd& values, Process& process,
                           double& score) const {
  const Index m = design_.rows(), q = trend_.cols();
  MatrixXd bordered = MatrixXd::Zero(m + q, m + q);
  bordered.topLeftCorner(m, m) = kernel(design_, design_, lengths);
  bordered.diagonal().head(runs_).array() += nugget;
  bordered.diagonal().segment(runs_, m - runs_).array() += 1e-10;  // the anchors are exact
  bordered.topRightCorner(m, q) = trend_;
  bordered.bottomLeftCorner(q, m) = trend_.transpose();
  process.lengths = lengths;
  process.inverse = bordered.partialPivLu().inverse();
  if (!process.inverse.allFinite()) return false;
  VectorXd padded = VectorXd::Zero(m + q);
  padded.head(m) = values;
  process.weights = process.inverse * padded;
  const Eigen::ArrayXd precision = process.inverse.diagonal().head(runs_).array();
  if (!(precision > 0.0).all()) return false;
  // Leave-one-out errors are weights / precision, of variance `variance` / precision.
  process.variance = (process.weights.head(runs_).array().square() / precision).mean();
  process.variance = std::max(process.variance, std::numeric_limits<double>::min());
  score = precision.log().mean() - std::log(process.variance);
  return true;
}

void CurveEmulator::fit(const VectorXd& values, Process& process) const {
  double best = -std::numeric_limits<double>::infinity();
  VectorXd lengths = VectorXd::Constant(dimensions(), 0.7);
  double nugget = 1e-6;
  const auto consider = [&](const VectorXd& trial_lengths, double trial_nugget) {
    Process trial;
    double score = 0.0;
    if (!factor(trial_lengths, trial_nugget, values, trial, score) || score <= best + 1e-9) return;
    best = score;
    lengths = trial_lengths;
    nugget = trial_nugget;
    process = trial;
  };
  consider(lengths, nugget);
  for (int sweep = 0; sweep < 2; ++sweep) {
    for (Index d = 0; d < dimensions(); ++d)
      for (const double length : {0.1, 0.2, 0.35, 0.7, 1.5, 4.0}) {
        VectorXd trial = lengths;
        trial(d) = length;
        consider(trial, nugget);
      }
    for (const double trial : {1e-8, 1e-6, 1e-4, 1e-2, 1e-1}) consider(lengths, trial);
  }
  if (process.weights.size() == 0) throw std::invalid_argument(name_ + ": a design too poor for its trend");
}

MatrixXd CurveEmulator::border(const Process& process, const MatrixXd& points) const {
  MatrixXd k(design_.rows() + trend_.cols(), points.rows());
  k.topRows(design_.rows()) = kernel(design_, points, process.lengths);
  k.bottomRows(trend_.cols()) = polynomial(points, quadratic_).transpose();
  return k;
}

MatrixXd CurveEmulator::scores(const MatrixXd& points) const {
  MatrixXd result(components_.cols(), points.rows());
  for (Index c = 0; c < result.rows(); ++c) {
    const Process& process = processes_[static_cast<std::size_t>(c)];
    result.row(c) = process.weights.transpose() * border(process, points);
  }
  return result;
}

CurveEmulator::ErrorScales CurveEmulator::error_scales(const MatrixXd& points) const {
  VectorXd variance = VectorXd::Zero(points.rows());
  for (const Process& process : processes_) {
    const MatrixXd k = border(process, points);
    const VectorXd explained = k.cwiseProduct(process.inverse * k).colwise().sum();
    variance += process.variance * (1.0 - explained.array()).cwiseMax(0.0).matrix();
  }
  ErrorScales scales{VectorXd::Zero(points.rows()), VectorXd::Zero(points.rows())};
  if (left_out_variance_ > 0.0) scales.left_out = variance / left_out_variance_;
  if (joint_left_.cols() > 0 && joint_power_ > 0.0)
    scales.joint = scores(points).colwise().squaredNorm().transpose() / joint_power_;
  return scales;
}

VectorXd CurveEmulator::error_scale(const MatrixXd& points) const {
  const ErrorScales scales = error_scales(points);
  return left_out_share_ * scales.left_out + (1.0 - left_out_share_) * scales.joint;
}

VectorXd CurveEmulator::mean(const VectorXd& phi) const { return components_ * scores(phi.transpose()); }

MatrixXd CurveEmulator::covariance(const VectorXd& phi) const {
  return error_scale(phi.transpose())(0) * error_;
}

CurveEmulator CurveEmulator::scaled(const VectorXd& factors, const MatrixXd& joint_residuals) const {
  CurveEmulator emulator = *this;
  emulator.components_ = factors.asDiagonal() * components_;
  emulator.left_out_ = factors.asDiagonal() * left_out_;
  emulator.joint_left_ = joint_residuals;
  emulator.error_ = factors.asDiagonal() * error_ * factors.asDiagonal();
  return emulator;
}

CurveEmulator CurveEmulator::rows(const std::vector<Index>& kept) const {
  CurveEmulator emulator = *this;
  emulator.components_ = components_(kept, Eigen::all);
  emulator.left_out_ = left_out_(kept, Eigen::all);
  if (joint_left_.cols() > 0) emulator.joint_left_ = joint_left_(kept, Eigen::all);
  emulator.error_ = error_(kept, kept);
  return emulator;
}

}  // namespace cpt::diagnosis

#include "results/emulator/gaussian_process.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cpt::results {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Mask = Eigen::Array<bool, Eigen::Dynamic, 1>;

constexpr double jitter = 1e-10;  // [-] of runs without noise, so that the matrix has a factor

Mask with_more_than_two_values(const MatrixXd& design) {
  Mask more(design.cols());
  for (Index d = 0; d < design.cols(); ++d) {
    const double least = design.col(d).minCoeff(), most = design.col(d).maxCoeff();
    more(d) = !(design.col(d).array() == least || design.col(d).array() == most).all();
  }
  return more;
}

MatrixXd trend_at(const MatrixXd& points, Trend trend, const Mask& squared) {
  const Index d = points.cols();
  MatrixXd terms(points.rows(), trend_terms(d, trend));
  Index column = 0;
  terms.col(column++).setOnes();
  if (trend != Trend::constant) {
    terms.middleCols(column, d) = points;
    column += d;
  }
  for (Index i = 0; trend == Trend::quadratic && i < d; ++i)
    for (Index j = i; j < d; ++j)
      if (i != j || squared(i)) terms.col(column++) = points.col(i).cwiseProduct(points.col(j));
  return terms.leftCols(column);
}

// L, Q and R of one choice of lengths and nugget; none where the matrix has no factor or the trend no rank.
struct Factored {
  MatrixXd factor, q, r;
};
std::optional<Factored> factored(MatrixXd covariance, const MatrixXd& trend, double nugget, Index exact) {
  const Index noisy = covariance.rows() - exact;
  covariance.diagonal().head(noisy).array() += std::max(nugget, jitter);
  covariance.diagonal().tail(exact).array() += jitter;
  const Eigen::LLT<MatrixXd> cholesky(covariance);
  if (cholesky.info() != Eigen::Success) return std::nullopt;
  Factored made;
  made.factor = cholesky.matrixL();
  const MatrixXd whitened = made.factor.triangularView<Eigen::Lower>().solve(trend);
  const Eigen::HouseholderQR<MatrixXd> qr(whitened);
  made.q = qr.householderQ() * MatrixXd::Identity(trend.rows(), trend.cols());
  made.r = qr.matrixQR().topRows(trend.cols()).triangularView<Eigen::Upper>();
  const Eigen::ArrayXd pivots = made.r.diagonal().array().abs();
  if (!(pivots.minCoeff() > 1e-10 * pivots.maxCoeff())) return std::nullopt;
  return made;
}

// y less the trend, whitened, with the variance of Z and the density that follow.
struct Whitened {
  VectorXd values;  // (I - Q Q^T) L^-1 y
  double variance, density;
};
Whitened whitened(const Factored& by, const VectorXd& values) {
  Whitened made;
  made.values = by.factor.triangularView<Eigen::Lower>().solve(values);
  made.values -= by.q * (by.q.transpose() * made.values);
  const auto freedom = static_cast<double>(by.q.rows() - by.q.cols());
  made.variance = std::max(made.values.squaredNorm() / freedom, std::numeric_limits<double>::min());
  made.density =
      -(by.factor.diagonal().array().log().sum() + by.r.diagonal().array().abs().log().sum()) / freedom -
      0.5 * std::log(made.variance);
  return made;
}

void check(const MatrixXd& design, const VectorXd& values, Index exact) {
  if (design.rows() != values.size() || design.cols() < 1 || exact < 0 || exact >= design.rows())
    throw std::invalid_argument("runs, inputs and values do not agree");
  if (!design.allFinite() || !values.allFinite())
    throw std::invalid_argument("runs and values must be finite");
}

}  // namespace

Index trend_terms(Index inputs, Trend trend) {
  switch (trend) {
    case Trend::constant:
      return 1;
    case Trend::linear:
      return 1 + inputs;
    case Trend::quadratic:
      return (inputs + 1) * (inputs + 2) / 2;
  }
  return 0;
}

Trend trend_for(Index runs, Index inputs) {
  for (const Trend trend : {Trend::quadratic, Trend::linear})
    if (runs >= 2 * trend_terms(inputs, trend)) return trend;
  return Trend::constant;
}

MatrixXd matern_5_2(const MatrixXd& a, const MatrixXd& b, const VectorXd& lengths) {
  const VectorXd per_length = std::sqrt(5.0) * lengths.cwiseInverse();
  const MatrixXd x = per_length.asDiagonal() * a.transpose(), y = per_length.asDiagonal() * b.transpose();
  MatrixXd k(a.rows(), b.rows());
  for (Index j = 0; j < k.cols(); ++j) {
    const Eigen::ArrayXd squares = (x.colwise() - y.col(j)).colwise().squaredNorm().transpose();
    const Eigen::ArrayXd r = squares.sqrt();
    k.col(j) = (1.0 + r + squares / 3.0) * (-r).exp();
  }
  return k;
}

GaussianProcess::GaussianProcess(MatrixXd design, VectorXd values, Trend trend, Kernel kernel, Index exact)
    : design_(std::move(design)),
      values_(std::move(values)),
      trend_(trend),
      kernel_(std::move(kernel)),
      exact_(exact) {
  check(design_, values_, exact_);
  if (kernel_.lengths.size() != design_.cols() || !kernel_.lengths.allFinite() ||
      !(kernel_.lengths.array() > 0.0).all() || !std::isfinite(kernel_.nugget) || kernel_.nugget < 0.0)
    throw std::invalid_argument("a kernel has a positive length for each input and a nugget of at least 0");
  squared_ = with_more_than_two_values(design_);
  const MatrixXd terms = trend_at(design_, trend_, squared_);
  std::optional<Factored> made;
  if (terms.cols() < design_.rows())
    made = factored(matern_5_2(design_, design_, kernel_.lengths), terms, kernel_.nugget, exact_);
  if (!made) throw std::invalid_argument("a design too poor for its trend");
  const Whitened by = whitened(*made, values_);
  factor_ = std::move(made->factor);
  trend_q_ = std::move(made->q);
  trend_r_ = std::move(made->r);
  variance_ = by.variance;
  const auto lower = factor_.triangularView<Eigen::Lower>();
  weights_ = factor_.transpose().triangularView<Eigen::Upper>().solve(by.values);
  coefficients_ =
      trend_r_.triangularView<Eigen::Upper>().solve(trend_q_.transpose() * VectorXd(lower.solve(values_)));
  // The diagonal of the bordered inverse; an error is weight / precision, of variance `variance` / precision.
  const MatrixXd inverse = lower.solve(MatrixXd::Identity(design_.rows(), design_.rows()));
  const VectorXd precisions =
      inverse.colwise().squaredNorm().transpose() - (inverse.transpose() * trend_q_).rowwise().squaredNorm();
  left_out_errors_ = weights_.head(runs()).cwiseQuotient(precisions.head(runs()));
  left_out_variances_ = variance_ * precisions.head(runs()).cwiseInverse();
  if (!left_out_errors_.allFinite() || !(precisions.head(runs()).array() > 0.0).all())
    throw std::invalid_argument("a design too poor for its trend");
}

GaussianProcess GaussianProcess::fit(const MatrixXd& design, const VectorXd& values, Trend trend,
                                     const KernelSearch& search, Index exact) {
  check(design, values, exact);
  const MatrixXd terms = trend_at(design, trend, with_more_than_two_values(design));
  if (terms.cols() >= design.rows()) throw std::invalid_argument("a design too poor for its trend");
  double best = -std::numeric_limits<double>::infinity();
  Kernel kernel{VectorXd::Constant(design.cols(), 0.7), 1e-6};
  const auto consider = [&](const Kernel& trial) {
    const auto made = factored(matern_5_2(design, design, trial.lengths), terms, trial.nugget, exact);
    if (!made) return;
    const double density = whitened(*made, values).density;
    if (!(density > best + 1e-9)) return;
    best = density;
    kernel = trial;
  };
  constexpr std::array lengths = {0.1, 0.2, 0.35, 0.7, 1.5, 4.0};
  constexpr std::array nuggets = {1e-8, 1e-6, 1e-4, 1e-2, 1e-1, 1.0};
  // All lengths alike first, with any noise: short lengths without noise and long ones with it are both a
  // peak.
  for (const double length : lengths)
    for (const double nugget : nuggets) consider({VectorXd::Constant(design.cols(), length), nugget});
  for (int sweep = 0; sweep < search.sweeps; ++sweep) {
    for (Index d = 0; d < design.cols(); ++d)
      for (const double length : lengths) {
        Kernel trial = kernel;
        trial.lengths(d) = length;
        consider(trial);
      }
    for (const double nugget : nuggets) consider({kernel.lengths, nugget});
  }
  double step = 1.4;
  for (int sweep = 0; sweep < search.refinements; ++sweep, step = std::sqrt(step)) {
    for (Index d = 0; d < design.cols(); ++d)
      for (const double by : {step, 1.0 / step}) {
        Kernel trial = kernel;
        trial.lengths(d) *= by;
        consider(trial);
      }
    for (const double by : {step * step * step, 1.0 / (step * step * step)})
      consider({kernel.lengths, kernel.nugget * by});
  }
  return {design, values, trend, kernel, exact};
}

GaussianProcess::Border GaussianProcess::border(const MatrixXd& points) const {
  Border made;
  made.runs = factor_.triangularView<Eigen::Lower>().solve(matern_5_2(design_, points, kernel_.lengths));
  const MatrixXd left = trend_r_.transpose().triangularView<Eigen::Lower>().solve(
      trend_at(points, trend_, squared_).transpose());
  made.trend = left - trend_q_.transpose() * made.runs;
  return made;
}

VectorXd GaussianProcess::mean(const MatrixXd& points) const {
  return trend_at(points, trend_, squared_) * coefficients_ +
         matern_5_2(points, design_, kernel_.lengths) * weights_;
}

VectorXd GaussianProcess::mean_variance(const MatrixXd& points) const {
  const Border at = border(points);
  const Eigen::ArrayXd explained = at.runs.colwise().squaredNorm().transpose();
  const Eigen::ArrayXd by_trend = at.trend.colwise().squaredNorm().transpose();
  return variance_ * (1.0 - explained + by_trend).cwiseMax(0.0).matrix();
}

GaussianProcess::AtPoint GaussianProcess::at(const Eigen::RowVectorXd& point) const {
  const VectorXd near = matern_5_2(design_, point, kernel_.lengths);
  const VectorXd terms = trend_at(point, trend_, squared_).transpose();
  const VectorXd solved = factor_.triangularView<Eigen::Lower>().solve(near);
  const VectorXd left = VectorXd(trend_r_.transpose().triangularView<Eigen::Lower>().solve(terms)) -
                        trend_q_.transpose() * solved;
  return {terms.dot(coefficients_) + near.dot(weights_),
          variance_ * std::max(0.0, 1.0 - solved.squaredNorm() + left.squaredNorm())};
}

MatrixXd GaussianProcess::mean_covariance(const MatrixXd& a, const MatrixXd& b) const {
  // Solved for `b` alone, so that many points of `a` cost their covariances with the runs.
  const Border at_b = border(b);
  const MatrixXd solved =
      factor_.transpose().triangularView<Eigen::Upper>().solve(at_b.runs + trend_q_ * at_b.trend);
  return variance_ *
         (matern_5_2(a, b, kernel_.lengths) - matern_5_2(a, design_, kernel_.lengths) * solved +
          trend_at(a, trend_, squared_) * trend_r_.triangularView<Eigen::Upper>().solve(at_b.trend));
}

}  // namespace cpt::results

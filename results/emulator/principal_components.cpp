#include "results/emulator/principal_components.hpp"

#include <algorithm>
#include <cstdlib>

namespace cpt::results {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Over all values, also of those that have no partner so far on: the estimate that is never indefinite
// (Brockwell & Davis 1991, Time Series: Theory and Methods, section 7.2).
VectorXd correlation_by_distance(const MatrixXd& rest, const VectorXd& variance) {
  const Index values = rest.rows();
  const VectorXd scale = (variance.array() > 0.0).select(variance.cwiseSqrt().cwiseInverse(), 0.0);
  const MatrixXd unit = scale.asDiagonal() * rest;
  VectorXd sums(values);
  for (Index k = 0; k < values; ++k)
    sums(k) = unit.topRows(values - k).cwiseProduct(unit.bottomRows(values - k)).sum();
  if (!(sums(0) > 0.0)) return VectorXd::Unit(values, 0);
  return sums / sums(0);
}

}  // namespace

PrincipalComponents principal_components(const MatrixXd& curves, double variance_left, Index most) {
  PrincipalComponents found;
  found.mean = curves.rowwise().mean();
  const MatrixXd about = curves.colwise() - found.mean;
  const Eigen::BDCSVD<MatrixXd> svd(about, Eigen::ComputeThinU);
  const VectorXd power = svd.singularValues().cwiseAbs2();
  Index kept = 0;
  for (double rest = power.sum();
       kept < std::min(most, power.size()) && rest > variance_left * power.sum() && power(kept) > 0.0;)
    rest -= power(kept++);
  found.shapes = svd.matrixU().leftCols(kept);
  for (Index c = 0; c < kept; ++c) {
    Index largest = 0;
    found.shapes.col(c).cwiseAbs().maxCoeff(&largest);
    if (found.shapes(largest, c) < 0.0) found.shapes.col(c) *= -1.0;
  }
  const MatrixXd rest = about - found.shapes * (found.shapes.transpose() * about);
  found.left_out = rest.cwiseAbs2().rowwise().mean();
  found.left_out_correlation = correlation_by_distance(rest, found.left_out);
  return found;
}

MatrixXd left_out_covariance(const PrincipalComponents& components) {
  const Index values = components.left_out.size();
  const VectorXd deviation = components.left_out.cwiseSqrt();
  MatrixXd covariance(values, values);
  for (Index i = 0; i < values; ++i)
    for (Index j = 0; j < values; ++j)
      covariance(i, j) = deviation(i) * deviation(j) * components.left_out_correlation(std::abs(i - j));
  return covariance;
}

MatrixXd scores(const PrincipalComponents& components, const MatrixXd& curves) {
  return components.shapes.transpose() * (curves.colwise() - components.mean);
}

}  // namespace cpt::results

#include "parameters/distributions/copula.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double least_eigenvalue = 1e-8;
constexpr double edge = 1e-12;  // places are kept so far from 0 and 1, where normal scores are infinite

MatrixXd with_eigenvalues_of_at_least(const MatrixXd& matrix, double least) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix);
  const VectorXd values = solver.eigenvalues().cwiseMax(least);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

MatrixXd with_unit_diagonal(const MatrixXd& matrix) {
  const VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  MatrixXd symmetric = 0.5 * (scaled + scaled.transpose());
  symmetric.diagonal().setOnes();
  return symmetric;
}

}  // namespace

double score_correlation(double rank) { return 2.0 * std::sin(std::numbers::pi * rank / 6.0); }

double rank_correlation(double score) { return 6.0 / std::numbers::pi * std::asin(score / 2.0); }

bool positive_definite(const MatrixXd& correlation) {
  if (correlation.size() == 0) return true;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(correlation, Eigen::EigenvaluesOnly);
  return solver.eigenvalues().minCoeff() >= least_eigenvalue;
}

MatrixXd nearest_correlation(const MatrixXd& matrix) {
  constexpr int most_steps = 1000;
  constexpr double enough = 1e-12;
  MatrixXd nearest = matrix, correction = MatrixXd::Zero(matrix.rows(), matrix.cols());
  for (int step = 0; step < most_steps; ++step) {
    const MatrixXd before = nearest, shifted = nearest - correction;
    // Somewhat above the least, as the diagonal's ones take a little of it away again.
    const MatrixXd definite = with_eigenvalues_of_at_least(shifted, 2.0 * least_eigenvalue);
    correction = definite - shifted;
    nearest = definite;
    nearest.diagonal().setOnes();
    if ((nearest - before).norm() <= enough * std::max(1.0, before.norm())) break;
  }
  return with_unit_diagonal(with_eigenvalues_of_at_least(nearest, 2.0 * least_eigenvalue));
}

MatrixXd dependent_places(const MatrixXd& places, const MatrixXd& correlation) {
  const boost::math::normal_distribution<double> normal;
  const MatrixXd factor = correlation.llt().matrixL();
  MatrixXd dependent = places;
  for (Index run = 0; run < places.rows(); ++run) {
    VectorXd scores(places.cols());
    for (Index j = 0; j < places.cols(); ++j)
      scores(j) = std::isnan(places(run, j))
                      ? places(run, j)
                      : boost::math::quantile(normal, std::clamp(places(run, j), edge, 1.0 - edge));
    for (Index j = 1; j < places.cols(); ++j) {
      const VectorXd weights = factor.row(j).head(j).transpose();
      if (weights.isZero(0.0)) continue;  // independent of those before: as it is
      dependent(run, j) = boost::math::cdf(normal, weights.dot(scores.head(j)) + factor(j, j) * scores(j));
    }
  }
  return dependent;
}

}  // namespace cpt::parameters

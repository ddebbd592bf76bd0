#include "results/emulator/principal_components.hpp"

#include <algorithm>

namespace cpt::results {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

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
  return found;
}

MatrixXd scores(const PrincipalComponents& components, const MatrixXd& curves) {
  return components.shapes.transpose() * (curves.colwise() - components.mean);
}

}  // namespace cpt::results

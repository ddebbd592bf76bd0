#include "diagnosis/predictive_check.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

// The first column of `rests` is the recording's, the others the replicates'.
PredictiveCheck compare(const std::vector<Cell>& cells, const Whitener& covariance, const MatrixXd& rests,
                        int least_cells) {
  const StepScan scan(cells, covariance, least_cells);
  const VectorXd chi_square = covariance.whiten(rests).colwise().squaredNorm().transpose();
  const VectorXd greatest = scan.greatest(covariance.solve(rests));
  const Index replicates = rests.cols() - 1;
  PredictiveCheck check;
  check.chi_square = chi_square(0);
  check.chi_square_p = bootstrap_p(chi_square(0), chi_square.tail(replicates));
  check.scan = greatest(0);
  check.scan_p = bootstrap_p(greatest(0), greatest.tail(replicates));
  check.p = std::min(1.0, 2.0 * std::min(check.chi_square_p, check.scan_p));
  return check;
}

// Nodes that a refit may choose: those not quite without weight.
MatrixXd likely_nodes(const MechanismEvidence& posterior) {
  const double least = 1e-6 * posterior.probability.maxCoeff();
  std::vector<Index> kept;
  for (Index i = 0; i < posterior.probability.size(); ++i)
    if (posterior.probability(i) >= least) kept.push_back(i);
  return posterior.nodes(kept, Eigen::all);
}

Index draw(const VectorXd& probability, double uniform) {
  Index i = 0;
  for (double below = probability(0); below < uniform && i + 1 < probability.size();)
    below += probability(++i);
  return i;
}

}  // namespace

PredictiveCheck check_null(const std::vector<Cell>& cells, const Whitener& covariance,
                           const VectorXd& residual, const MatrixXd& null_draws, int least_cells) {
  MatrixXd rests(residual.size(), null_draws.cols() + 1);
  rests << residual, null_draws;
  return compare(cells, covariance, rests, least_cells);
}

PredictiveCheck check_mechanism(const std::vector<Cell>& cells, const MatrixXd& null_covariance,
                                const CurveEmulator& emulator, const MechanismEvidence& posterior,
                                const VectorXd& residual, const MatrixXd& null_draws, std::uint64_t seed,
                                int least_cells) {
  const MatrixXd error = emulator.covariance(posterior.mode);
  const Whitener covariance(null_covariance + error);
  const bool exact = !(error.trace() > 1e-9 * null_covariance.trace());
  const Whitener error_factor(exact ? MatrixXd(MatrixXd::Identity(error.rows(), error.cols())) : error);

  const Index n = residual.size();
  MatrixXd y(n, null_draws.cols() + 1);
  y.col(0) = residual;
  for (Index k = 0; k < null_draws.cols(); ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    const Index node = draw(posterior.probability, random.uniform());
    y.col(k + 1) = null_draws.col(k) + emulator.mean(posterior.nodes.row(node).transpose());
    if (!exact) y.col(k + 1) += error_factor.colour(random.normals(n));
  }

  // |y - A|^2 = |y|^2 - 2 A^T y + |A|^2 for all nodes and replicates by one product.
  const MatrixXd curves = emulator.components() * emulator.scores(likely_nodes(posterior));
  const MatrixXd A = covariance.whiten(curves);
  MatrixXd closeness = A.transpose() * covariance.whiten(y);
  closeness.colwise() -= 0.5 * A.colwise().squaredNorm().transpose();
  for (Index k = 0; k < y.cols(); ++k) {
    Index best = 0;
    closeness.col(k).maxCoeff(&best);
    y.col(k) -= curves.col(best);
  }
  return compare(cells, covariance, y, least_cells);
}

}  // namespace cpt::diagnosis

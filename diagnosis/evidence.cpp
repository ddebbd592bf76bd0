#include "diagnosis/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

constexpr double negligible = 16.0;  // in ln density below the best node

struct Box {
  VectorXd lower, upper;
  [[nodiscard]] double volume() const { return (upper - lower).prod(); }
};

Box prior_box(const CurveEmulator& emulator, const GridOptions& options) {
  Box box{VectorXd::Zero(emulator.dimensions()), VectorXd::Ones(emulator.dimensions())};
  if (emulator.vanishes_at_zero()) box.upper(0) = options.strength_limit;
  return box;
}

// Around the nodes that carry weight, with the next node to either side.
Box around(const MatrixXd& nodes, const VectorXd& log_density, const Box& box) {
  const double floor = log_density.maxCoeff() - negligible;
  Box next = box;
  for (Index d = 0; d < nodes.cols(); ++d) {
    double least = box.upper(d), most = box.lower(d);
    for (Index i = 0; i < nodes.rows(); ++i) {
      if (log_density(i) < floor) continue;
      least = std::min(least, nodes(i, d));
      most = std::max(most, nodes(i, d));
    }
    for (Index i = 0; i < nodes.rows(); ++i) {
      if (nodes(i, d) < least) next.lower(d) = std::max(next.lower(d), nodes(i, d));
      if (nodes(i, d) > most) next.upper(d) = std::min(next.upper(d), nodes(i, d));
    }
  }
  return next;
}

// The value below which a share of the probability lies, linear between the nodes' mid-probabilities.
double quantile(const VectorXd& values, const VectorXd& probability, double share) {
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return values(a) < values(b); });
  double below = 0.0, last_value = values(order.front()), last_share = 0.0;
  for (std::size_t i = 0; i < order.size();) {
    const double value = values(order[i]);
    double here = 0.0;
    for (; i < order.size() && values(order[i]) - value < 1e-12; ++i) here += probability(order[i]);
    const double middle = below + 0.5 * here;
    if (middle >= share)
      return middle > last_share
                 ? last_value + (value - last_value) * (share - last_share) / (middle - last_share)
                 : value;
    below += here;
    last_value = value;
    last_share = middle;
  }
  return last_value;
}

int nodes_for(Index dimensions, const GridOptions& options) { return options.nodes[dimensions - 1]; }

}  // namespace

MechanismLikelihood::MechanismLikelihood(const CurveEmulator& emulator, const Whitener& null)
    : emulator_(emulator), null_(null) {
  const MatrixXd half = null_.whiten(emulator_.error_covariance());
  const MatrixXd error = null_.whiten(half.transpose());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (error + error.transpose()));
  rotation_ = eigen.eigenvectors().transpose();
  relative_ = eigen.eigenvalues().cwiseMax(0.0);
  components_ = rotation_ * null_.whiten(emulator_.components());
}

VectorXd MechanismLikelihood::log_density(const MatrixXd& points, const VectorXd& residual) const {
  const VectorXd r = rotation_ * null_.whiten(residual);
  const MatrixXd scores = emulator_.scores(points);
  const VectorXd scale = emulator_.error_scale(points);
  const double constant =
      static_cast<double>(r.size()) * std::log(2.0 * std::numbers::pi) + null_.log_determinant();
  VectorXd result(points.rows());
  for (Index i = 0; i < points.rows(); ++i) {
    const Eigen::ArrayXd variance = 1.0 + scale(i) * relative_.array();
    const Eigen::ArrayXd rest = (r - components_ * scores.col(i)).array();
    result(i) = -0.5 * (constant + variance.log().sum() + (rest.square() / variance).sum());
  }
  return result;
}

MechanismEvidence mechanism_evidence(const MechanismLikelihood& likelihood, const VectorXd& residual,
                                     const GridOptions& options) {
  const CurveEmulator& emulator = likelihood.emulator();
  const Box prior = prior_box(emulator, options);
  const int points = nodes_for(emulator.dimensions(), options);
  Box box = prior;
  Quadrature rule;
  VectorXd log_density;
  for (int round = 0;; ++round) {
    rule = box_rule(box.lower, box.upper, points);
    log_density = likelihood.log_density(rule.nodes, residual);
    const Box next = around(rule.nodes, log_density, box);
    if (round == options.refinements || next.volume() > 0.5 * box.volume()) break;
    box = next;
  }
  const VectorXd log_weights = log_density + rule.weights.array().log().matrix();
  const double total = log_sum_exp(log_weights);

  MechanismEvidence result;
  result.name = emulator.name();
  result.log_evidence = total + std::log(box.volume() / prior.volume());
  result.probability = (log_weights.array() - total).exp();
  result.nodes = rule.nodes;
  const Index d = emulator.dimensions();
  result.mean = rule.nodes.transpose() * result.probability;
  const MatrixXd away = rule.nodes.rowwise() - result.mean.transpose();
  result.deviation = (away.cwiseAbs2().transpose() * result.probability).cwiseSqrt();
  Index best = 0;
  log_density.maxCoeff(&best);
  result.mode = rule.nodes.row(best).transpose();
  result.lower.resize(d);
  result.upper.resize(d);
  for (Index k = 0; k < d; ++k) {
    result.lower(k) = quantile(rule.nodes.col(k), result.probability, 0.05);
    result.upper(k) = quantile(rule.nodes.col(k), result.probability, 0.95);
  }
  return result;
}

PairEvidence pair_evidence(const CurveEmulator& first, const CurveEmulator& second,
                           const MatrixXd& null_covariance, const VectorXd& residual,
                           const GridOptions& options) {
  const Whitener whitener(null_covariance + first.error_covariance() + second.error_covariance());
  const VectorXd r = whitener.whiten(residual);
  const MatrixXd first_components = whitener.whiten(first.components());
  const MatrixXd second_components = whitener.whiten(second.components());
  constexpr int points[] = {61, 19, 8};  // about 400 nodes each: all pairs are compared
  const Box first_prior = prior_box(first, options), second_prior = prior_box(second, options);
  Box a = first_prior, b = second_prior;
  const double constant =
      static_cast<double>(r.size()) * std::log(2.0 * std::numbers::pi) + whitener.log_determinant();
  for (int round = 0;; ++round) {
    const Quadrature rule_a = box_rule(a.lower, a.upper, points[first.dimensions() - 1]);
    const Quadrature rule_b = box_rule(b.lower, b.upper, points[second.dimensions() - 1]);
    const MatrixXd curves_a = (first_components * first.scores(rule_a.nodes)).colwise() - r;
    const MatrixXd curves_b = second_components * second.scores(rule_b.nodes);
    // |A_i + B_j - r|^2 for all pairs by one product.
    MatrixXd log_density = -(curves_a.transpose() * curves_b);
    log_density.colwise() -= 0.5 * curves_a.colwise().squaredNorm().transpose();
    log_density.rowwise() -= 0.5 * curves_b.colwise().squaredNorm();
    log_density.array() -= 0.5 * constant;

    const Box next_a = around(rule_a.nodes, log_density.rowwise().maxCoeff(), a);
    const Box next_b = around(rule_b.nodes, log_density.colwise().maxCoeff().transpose(), b);
    const double shrinkage = next_a.volume() * next_b.volume() / (a.volume() * b.volume());
    if (round < options.refinements && shrinkage <= 0.5) {
      a = next_a;
      b = next_b;
      continue;
    }
    Index i = 0, j = 0;
    log_density.maxCoeff(&i, &j);
    log_density.colwise() += rule_a.weights.array().log().matrix();
    log_density.rowwise() += rule_b.weights.array().log().matrix().transpose();
    const double share = a.volume() * b.volume() / (first_prior.volume() * second_prior.volume());
    return {first.name(), second.name(), log_sum_exp(log_density.reshaped()) + std::log(share),
            rule_a.nodes.row(i).transpose(), rule_b.nodes.row(j).transpose()};
  }
}

VectorXd probabilities(const VectorXd& log_evidence, const VectorXd& prior) {
  const VectorXd log_joint = log_evidence.array() + prior.array().log();
  return (log_joint.array() - log_sum_exp(log_joint)).exp();
}

}  // namespace cpt::diagnosis

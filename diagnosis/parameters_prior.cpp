#include "diagnosis/parameters_prior.hpp"

#include <cmath>
#include <stdexcept>

#include "diagnosis/quadrature.hpp"
#include "diagnosis/random.hpp"

namespace cpt::diagnosis {
namespace {

// First two moments of (s, s^2) over a parameter's prior.
struct Moments {
  Eigen::Vector2d mean;
  Eigen::Matrix2d factor;  // lower, covariance = factor factor^T
};

Moments moments(double place, bool two_valued) {
  Quadrature rule = gauss_legendre(3);  // exact to the fifth degree; s^4 is the highest here
  if (two_valued) rule = {Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.5, 0.5)};
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (Index i = 0; i < rule.weights.size(); ++i) {
    const double s = rule.nodes(i, 0) - place;
    const Eigen::Vector2d v(s, s * s);
    mean += rule.weights(i) * v;
    second += rule.weights(i) * v * v.transpose();
  }
  const Eigen::Matrix2d covariance = second - mean * mean.transpose();
  Eigen::Matrix2d factor = Eigen::Matrix2d::Zero();
  factor(0, 0) = std::sqrt(covariance(0, 0));
  factor(1, 0) = covariance(1, 0) / factor(0, 0);
  factor(1, 1) = std::sqrt(std::max(0.0, covariance(1, 1) - factor(1, 0) * factor(1, 0)));
  return {mean, factor};
}

}  // namespace

AdditiveModel::AdditiveModel(VectorXd baseline, const std::vector<ParameterEffect>& effects)
    : baseline_(std::move(baseline)) {
  const Index n = baseline_.size();
  const auto p = static_cast<Index>(effects.size());
  place_.resize(p);
  linear_.setZero(n, p);
  quadratic_.setZero(n, p);
  for (Index j = 0; j < p; ++j) {
    const ParameterEffect& effect = effects[static_cast<std::size_t>(j)];
    const double t = effect.baseline;
    const bool below = effect.lower.size() > 0 && t > 0.0, above = effect.upper.size() > 0 && t < 1.0;
    if (!(t >= 0.0 && t <= 1.0) || !(below || above))
      throw std::invalid_argument(effect.name + ": no run away from the baseline, or no place for it");
    if ((below && effect.lower.size() != n) || (above && effect.upper.size() != n))
      throw std::invalid_argument(effect.name + ": a curve of another length");
    if (effect.two_valued && below && above)
      throw std::invalid_argument(effect.name + ": a choice has its baseline at an end");
    // Divided differences to either side of the baseline.
    const VectorXd down = below ? VectorXd((effect.lower - baseline_) / -t) : VectorXd();
    const VectorXd up = above ? VectorXd((effect.upper - baseline_) / (1.0 - t)) : VectorXd();
    if (below && above) {
      quadratic_.col(j) = up - down;
      linear_.col(j) = t * up + (1.0 - t) * down;
    } else {
      linear_.col(j) = below ? down : up;
    }
    names_.push_back(effect.name);
    place_(j) = t;
    two_valued_.push_back(effect.two_valued);
  }
}

VectorXd AdditiveModel::predict(const VectorXd& t) const {
  const VectorXd s = t - place_;
  return baseline_ + linear_ * s + quadratic_ * s.cwiseAbs2();
}

MatrixXd AdditiveModel::jacobian(const VectorXd& t) const {
  return linear_ + 2.0 * quadratic_ * (t - place_).asDiagonal();
}

VectorXd AdditiveModel::prior_mean() const {
  VectorXd mean = baseline_;
  for (Index j = 0; j < parameters(); ++j) {
    const Moments m = moments(place_(j), two_valued(j));
    mean += m.mean(0) * linear_.col(j) + m.mean(1) * quadratic_.col(j);
  }
  return mean;
}

MatrixXd AdditiveModel::prior_factors() const {
  MatrixXd factors(baseline_.size(), 2 * parameters());
  for (Index j = 0; j < parameters(); ++j) {
    const Moments m = moments(place_(j), two_valued(j));
    factors.col(2 * j) = m.factor(0, 0) * linear_.col(j) + m.factor(1, 0) * quadratic_.col(j);
    factors.col(2 * j + 1) = m.factor(1, 1) * quadratic_.col(j);
  }
  return factors;
}

AdditiveModel AdditiveModel::rows(const std::vector<Index>& kept) const {
  AdditiveModel model = *this;
  model.baseline_ = baseline_(kept);
  model.linear_ = linear_(kept, Eigen::all);
  model.quadratic_ = quadratic_(kept, Eigen::all);
  return model;
}

AdditiveModel AdditiveModel::widened(double width) const {
  AdditiveModel model = *this;
  for (Index j = 0; j < parameters(); ++j) {
    if (two_valued(j)) continue;
    model.linear_.col(j) *= width;
    model.quadratic_.col(j) *= width * width;
  }
  return model;
}

NullModel null_model(AdditiveModel parameters, MatrixXd sigma) {
  VectorXd mean = parameters.prior_mean();
  const MatrixXd factors = parameters.prior_factors();
  MatrixXd covariance = sigma + factors * factors.transpose();
  return {std::move(parameters), std::move(sigma), std::move(mean), std::move(covariance)};
}

MatrixXd draw_null(const NullModel& null, int count, std::uint64_t seed) {
  const Whitener noise(null.sigma);
  const AdditiveModel& model = null.parameters;
  MatrixXd z(null.mean.size(), count);
  MatrixXd curves(null.mean.size(), count);
  for (int k = 0; k < count; ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    VectorXd t(model.parameters());
    for (Index j = 0; j < t.size(); ++j) {
      t(j) = random.uniform();
      if (model.two_valued(j)) t(j) = t(j) < 0.5 ? 0.0 : 1.0;
    }
    curves.col(k) = model.predict(t) - null.mean;
    z.col(k) = random.normals(z.rows());
  }
  return curves + noise.colour(z);
}

}  // namespace cpt::diagnosis

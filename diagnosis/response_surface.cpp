#include "diagnosis/response_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

// E s^k over one parameter's prior, k = 0 ... 4.
std::array<double, 5> moments(double place, bool two_valued) {
  Quadrature rule = gauss_legendre(3);  // exact to the fifth degree
  if (two_valued) rule = {Eigen::Vector2d(0.0, 1.0), Eigen::Vector2d(0.5, 0.5)};
  std::array<double, 5> moments{};
  for (Index i = 0; i < rule.weights.size(); ++i)
    for (std::size_t k = 0; k < moments.size(); ++k)
      moments[k] += rule.weights(i) * std::pow(rule.nodes(i, 0) - place, static_cast<double>(k));
  return moments;
}

// Coefficients (features x n) of a ridge regression of values (runs x n), and what each run lies off the fit
// to the others.
struct Ridge {
  MatrixXd coefficients, left_out;
};

Ridge ridge(const MatrixXd& features, const MatrixXd& values, double penalty) {
  MatrixXd normal = features.transpose() * features;
  normal.diagonal().array() += penalty;
  const MatrixXd solver = normal.ldlt().solve(features.transpose());
  Ridge fit{solver * values, {}};
  const VectorXd leverage = (features * solver).diagonal();
  fit.left_out = (1.0 - leverage.array()).inverse().matrix().asDiagonal() *
                 MatrixXd(values - features * fit.coefficients);
  return fit;
}

// Sum of squares over the cells that have values in all runs.
double squares(const MatrixXd& values) {
  double sum = 0.0;
  for (const auto& cell : values.colwise())
    if (cell.allFinite()) sum += cell.squaredNorm();
  return sum;
}

}  // namespace

ResponseSurface::ResponseSurface(VectorXd baseline, const std::vector<ParameterEffect>& effects)
    : baseline_(std::move(baseline)) {
  const Index n = baseline_.size();
  const auto p = static_cast<Index>(effects.size());
  place_.resize(p);
  for (Index i = 0; i < p; ++i)
    for (Index j = i; j < p; ++j) pairs_.emplace_back(i, j);
  coefficients_.setZero(n, p + static_cast<Index>(pairs_.size()));
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
      coefficients_.col(column_of(j, j)) = up - down;
      coefficients_.col(j) = t * up + (1.0 - t) * down;
    } else {
      coefficients_.col(j) = below ? down : up;
    }
    names_.push_back(effect.name);
    place_(j) = t;
    two_valued_.push_back(effect.two_valued);
  }
  left_out_.resize(n, 0);
}

ResponseSurface::ResponseSurface(VectorXd baseline, const std::vector<ParameterEffect>& effects,
                                 const JointRuns& joint)
    : ResponseSurface(std::move(baseline), effects) {
  if (joint.curves.cols() > 0) learn(joint, effects);
}

void ResponseSurface::learn(const JointRuns& joint, const std::vector<ParameterEffect>& effects) {
  const Index runs = joint.curves.cols();
  if (joint.curves.rows() != baseline_.size() || joint.places.rows() != runs ||
      joint.places.cols() != parameters())
    throw std::invalid_argument("joint runs of another shape");
  const MatrixXd s = joint.places.rowwise() - place_.transpose();
  left_out_.resize(baseline_.size(), runs);
  for (Index k = 0; k < runs; ++k)
    left_out_.col(k) = joint.curves.col(k) - predict(joint.places.row(k).transpose());
  const MatrixXd rest = left_out_.transpose();  // by a surface without products

  // s_i s_j; and s_j (s_j - s_end) where there is a run at one end only.
  struct Feature {
    Index i, j;
    double end;
  };
  std::vector<Feature> features;
  for (const auto& [i, j] : pairs_) {
    if (i != j) features.push_back({i, j, 0.0});
    if (i != j || two_valued(j)) continue;
    const ParameterEffect& effect = effects[static_cast<std::size_t>(j)];
    const bool below = effect.lower.size() > 0 && place_(j) > 0.0;
    const bool above = effect.upper.size() > 0 && place_(j) < 1.0;
    if (below != above) features.push_back({j, j, above ? 1.0 - place_(j) : -place_(j)});
  }
  if (features.empty()) return;
  MatrixXd values(runs, static_cast<Index>(features.size()));
  for (std::size_t f = 0; f < features.size(); ++f) {
    const auto& [i, j, end] = features[f];
    values.col(static_cast<Index>(f)) = s.col(i).array() * (s.col(j).array() - end);
  }

  double least = squares(rest);  // no products at all
  MatrixXd learnt(0, baseline_.size());
  for (int step = 0; step <= 10; ++step) {
    const Ridge fit = ridge(values, rest, std::pow(10.0, 1.0 - 0.5 * step));
    if (!(squares(fit.left_out) < least)) continue;
    least = squares(fit.left_out);
    left_out_ = fit.left_out.transpose();
    learnt = fit.coefficients;
  }
  for (Index f = 0; f < learnt.rows(); ++f) {
    const auto& [i, j, end] = features[static_cast<std::size_t>(f)];
    coefficients_.col(column_of(i, j)) += learnt.row(f).transpose();
    coefficients_.col(j) -= end * learnt.row(f).transpose();
  }
}

Index ResponseSurface::column_of(Index i, Index j) const {
  const auto pair = std::ranges::find(pairs_, std::pair(i, j));
  return parameters() + static_cast<Index>(pair - pairs_.begin());
}

VectorXd ResponseSurface::monomials(const VectorXd& s) const {
  VectorXd values(coefficients_.cols());
  values.head(s.size()) = s;
  Index column = s.size();
  for (const auto& [i, j] : pairs_) values(column++) = s(i) * s(j);
  return values;
}

VectorXd ResponseSurface::predict(const VectorXd& t) const {
  return baseline_ + coefficients_ * monomials(t - place_);
}

MatrixXd ResponseSurface::jacobian(const VectorXd& t) const {
  const VectorXd s = t - place_;
  MatrixXd jacobian = coefficients_.leftCols(s.size());
  Index column = s.size();
  for (const auto& [i, j] : pairs_) {
    jacobian.col(i) += s(j) * coefficients_.col(column);
    jacobian.col(j) += s(i) * coefficients_.col(column);
    ++column;
  }
  return jacobian;
}

Eigen::MatrixXi ResponseSurface::exponents() const {
  const Index p = parameters();
  Eigen::MatrixXi powers = Eigen::MatrixXi::Zero(coefficients_.cols() + 1, p);
  powers.topRows(p).setIdentity();
  Index row = p;
  for (const auto& [i, j] : pairs_) {
    ++powers(row, i);
    ++powers(row++, j);
  }
  return powers;
}

// The parameters are independent, so the mean of a monomial is the product of the parameters' moments.
MatrixXd ResponseSurface::second_moments(const Moments& moments) const {
  const Eigen::MatrixXi powers = exponents();
  MatrixXd result(powers.rows(), powers.rows());
  for (Index a = 0; a < result.rows(); ++a)
    for (Index b = 0; b < result.cols(); ++b) {
      double product = 1.0;
      for (std::size_t j = 0; j < moments.size(); ++j) {
        const auto column = static_cast<Index>(j);
        product *= moments[j][static_cast<std::size_t>(powers(a, column) + powers(b, column))];
      }
      result(a, b) = product;
    }
  return result;
}

MatrixXd ResponseSurface::prior_moments() const {
  Moments moment;
  for (Index j = 0; j < parameters(); ++j) moment.push_back(moments(place_(j), two_valued(j)));
  return second_moments(moment);
}

VectorXd ResponseSurface::prior_mean() const {
  return baseline_ + coefficients_ * prior_moments().col(coefficients_.cols()).head(coefficients_.cols());
}

MatrixXd ResponseSurface::factors_of(const MatrixXd& covariance) const {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(covariance);
  return coefficients_ * principal.eigenvectors() *
         principal.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

MatrixXd ResponseSurface::prior_factors() const {
  const Index count = coefficients_.cols();
  if (count == 0) return {baseline_.size(), 0};
  const MatrixXd second = prior_moments();
  const VectorXd mean = second.col(count).head(count);
  return factors_of(second.topLeftCorner(count, count) - mean * mean.transpose());
}

Linearized ResponseSurface::linearized(const std::vector<PlaceRule>& rules) const {
  const Index p = parameters(), count = coefficients_.cols();
  if (count == 0) return {baseline_, MatrixXd(baseline_.size(), 0), MatrixXd(baseline_.size(), 0)};
  Moments moment(rules.size());
  std::vector<std::array<double, 3>> along(rules.size());  // E s^k x
  for (std::size_t j = 0; j < rules.size(); ++j) {
    const Eigen::ArrayXd s = rules[j].places.array() - place_(static_cast<Index>(j));
    Eigen::ArrayXd power = rules[j].weights.array();
    for (std::size_t k = 0; k < moment[j].size(); ++k, power *= s) {
      moment[j][k] = power.sum();
      if (k < along[j].size()) along[j][k] = (power * rules[j].coordinates.array()).sum();
    }
  }
  const MatrixXd second = second_moments(moment);
  const VectorXd mean = second.col(count).head(count);
  // Of each monomial in each coordinate: the other parameters' moments times this one's along it.
  const Eigen::MatrixXi powers = exponents();
  MatrixXd slope(count, p);
  for (Index a = 0; a < count; ++a)
    for (Index j = 0; j < p; ++j) {
      slope(a, j) = along[static_cast<std::size_t>(j)][static_cast<std::size_t>(powers(a, j))];
      for (Index i = 0; i < p; ++i)
        if (i != j)
          slope(a, j) *= moment[static_cast<std::size_t>(i)][static_cast<std::size_t>(powers(a, i))];
    }
  const MatrixXd rest =
      second.topLeftCorner(count, count) - mean * mean.transpose() - slope * slope.transpose();
  return {baseline_ + coefficients_ * mean, coefficients_ * slope, factors_of(rest)};
}

ResponseSurface ResponseSurface::widened(double width) const {
  ResponseSurface surface = *this;
  const auto by = [&](Index j) { return two_valued(j) ? 1.0 : width; };
  for (Index j = 0; j < parameters(); ++j) surface.coefficients_.col(j) *= by(j);
  Index column = parameters();
  for (const auto& [i, j] : pairs_) surface.coefficients_.col(column++) *= by(i) * by(j);
  return surface;
}

}  // namespace cpt::diagnosis

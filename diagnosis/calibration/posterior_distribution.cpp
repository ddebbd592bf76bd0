#include "diagnosis/calibration/posterior_distribution.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "parameters/distributions/copula.hpp"
#include "parameters/distributions/moments.hpp"

namespace cpt::diagnosis {
namespace {

using Eigen::VectorXd;
using parameters::Family;

constexpr std::array<double, 5> compared = {0.05, 0.25, 0.5, 0.75, 0.95};

double normal_quantile(double p) {
  return boost::math::quantile(boost::math::normal_distribution<double>(), p);
}

// Quantiles of the family with these moments; nothing where it has no such member.
std::function<double(double)> quantiles(Family family, const FittedDistribution& of) {
  if (family == Family::beta) {
    const auto beta = parameters::beta_from_moments(of.least, of.most, of.mean, of.deviation);
    if (!beta) return nullptr;
    const boost::math::beta_distribution<double> unit(beta->parameters[0], beta->parameters[1]);
    return [=](double p) { return std::lerp(of.least, of.most, boost::math::quantile(unit, p)); };
  }
  const auto made = parameters::from_moments(family, of.mean, of.deviation);
  if (!made) return nullptr;
  const double a = made->parameters[0], b = made->parameters[1];
  if (family == Family::lognormal) return [=](double p) { return std::exp(a + b * normal_quantile(p)); };
  return [=](double p) { return a + b * normal_quantile(p); };
}

}  // namespace

FittedDistribution fitted_distribution(const VectorXd& draws, double least, double most, bool discrete) {
  FittedDistribution fitted;
  fitted.least = least;
  fitted.most = most;
  fitted.mean = draws.mean();
  fitted.deviation = std::sqrt((draws.array() - fitted.mean).square().mean());
  if (discrete) {
    std::map<double, double> shares;
    for (const double draw : draws) shares[draw] += 1.0 / static_cast<double>(draws.size());
    fitted.family = Family::discrete;
    for (const auto& [value, share] : shares) {
      fitted.values.push_back(value);
      fitted.weights.push_back(share);
    }
    return fitted;
  }
  std::vector<double> sorted(draws.begin(), draws.end());
  std::ranges::sort(sorted);
  double nearest = -1.0;
  for (const Family family : {Family::normal, Family::lognormal, Family::beta}) {
    const auto quantile = quantiles(family, fitted);
    if (!quantile) continue;
    double apart = 0.0;
    for (const double p : compared) {
      const double here = sorted[static_cast<std::size_t>(p * static_cast<double>(sorted.size() - 1))];
      apart = std::max(apart, std::abs(quantile(p) - here) / fitted.deviation);
    }
    if (nearest >= 0.0 && apart >= nearest) continue;
    nearest = apart;
    fitted.family = family;
  }
  fitted.apart = nearest;
  return fitted;
}

Eigen::MatrixXd copula_rank_correlations(const Eigen::MatrixXd& found) {
  const auto rounded = [](double rho) { return std::round(100.0 * std::clamp(rho, -0.99, 0.99)) / 100.0; };
  Eigen::MatrixXd scores = Eigen::MatrixXd::Identity(found.rows(), found.cols());
  for (Eigen::Index a = 0; a < found.rows(); ++a)
    for (Eigen::Index b = 0; b < a; ++b)
      scores(a, b) = scores(b, a) = parameters::score_correlation(rounded(found(a, b)));
  if (!parameters::positive_definite(scores)) scores = parameters::nearest_correlation(scores);
  return scores.unaryExpr([](double score) { return parameters::rank_correlation(score); });
}

}  // namespace cpt::diagnosis

#include "diagnosis/several/soil.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "diagnosis/random.hpp"
#include "diagnosis/whitener.hpp"

namespace cpt::diagnosis {
namespace {

// The trapezoidal rule: of smooth functions of a normal it is exact to rounding.
PlaceRule rule_of(const std::function<double(double)>& place, double mean, double deviation) {
  constexpr Index half = 300;
  constexpr double step = 0.02;
  PlaceRule rule{VectorXd(2 * half), VectorXd(2 * half), VectorXd(2 * half)};
  for (Index i = 0; i < 2 * half; ++i) {
    const double x = (static_cast<double>(i - half) + 0.5) * step;
    rule.coordinates(i) = x;
    rule.weights(i) = std::exp(-0.5 * x * x);
    rule.places(i) = place(mean + deviation * x);
  }
  rule.weights /= rule.weights.sum();
  return rule;
}

}  // namespace

SoilPrior soil_prior(const std::vector<ParameterEffect>& parameters, const MatrixXd& correlation) {
  SoilPrior prior;
  for (const ParameterEffect& parameter : parameters) {
    if (parameter.two_valued)
      prior.place_of_score.emplace_back([](double z) { return z < 0.0 ? 0.0 : 1.0; });
    else if (parameter.place_of_score)
      prior.place_of_score.push_back(parameter.place_of_score);
    else
      prior.place_of_score.emplace_back([](double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); });
  }
  const auto p = static_cast<Index>(parameters.size());
  prior.lower = MatrixXd::Identity(p, p);
  if (correlation.size() == 0) return prior;
  const Eigen::LLT<MatrixXd> factor(correlation);
  if (correlation.rows() != p || correlation.cols() != p || factor.info() != Eigen::Success)
    throw std::invalid_argument("the parameters' correlation is none");
  prior.lower = factor.matrixL();
  return prior;
}

SoilBelief before_recording(const SoilPrior& prior) {
  const Index p = prior.lower.rows();
  return {VectorXd::Zero(p), VectorXd::Ones(p)};
}

LocalSoil local_soil(const ResponseSurface& surface, const SoilPrior& prior, const SoilBelief& belief) {
  std::vector<PlaceRule> rules;
  VectorXd places(belief.mean.size());
  for (Index j = 0; j < places.size(); ++j) {
    rules.push_back(
        rule_of(prior.place_of_score[static_cast<std::size_t>(j)], belief.mean(j), belief.deviation(j)));
    places(j) = rules.back().weights.dot(rules.back().places);
  }
  Linearized linear = surface.linearized(rules);
  const MatrixXd of_score = linear.slopes * belief.deviation.cwiseInverse().asDiagonal();
  return {linear.mean - of_score * belief.mean, of_score * prior.lower, std::move(linear.remainder),
          std::move(places)};
}

MatrixXd draw_soil(const ResponseSurface& surface, const SoilPrior& prior, const MatrixXd& scatter,
                   Index count, std::uint64_t seed) {
  const Whitener noise(scatter);
  const Index p = prior.lower.rows();
  MatrixXd curves(scatter.rows(), count), normals(scatter.rows(), count);
  for (Index k = 0; k < count; ++k) {
    Random random(seed, static_cast<std::uint64_t>(k));
    const VectorXd scores = prior.lower * random.normals(p);
    VectorXd t(p);
    for (Index j = 0; j < p; ++j) t(j) = prior.place_of_score[static_cast<std::size_t>(j)](scores(j));
    curves.col(k) = surface.predict(t);
    normals.col(k) = random.normals(normals.rows());
  }
  return curves + noise.colour(normals);
}

}  // namespace cpt::diagnosis

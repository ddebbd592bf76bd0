#include "parameters/distributions/moments.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace cpt::parameters {
namespace {

double normal_score(double probability) {
  return boost::math::quantile(boost::math::normal_distribution<double>(), probability);
}

}  // namespace

std::optional<Distribution> from_moments(Family family, double mean, double deviation) {
  if (!(deviation > 0.0)) return std::nullopt;
  switch (family) {
    case Family::normal:
      return Distribution{family, {mean, deviation}};
    case Family::lognormal: {
      if (!(mean > 0.0)) return std::nullopt;
      const double variance = std::log1p(std::pow(deviation / mean, 2));
      return Distribution{family, {std::log(mean) - variance / 2.0, std::sqrt(variance)}};
    }
    case Family::uniform: {
      const double half = std::sqrt(3.0) * deviation;
      return Distribution{family, {mean - half, mean + half}};
    }
    default:
      return std::nullopt;
  }
}

std::optional<Distribution> from_quantiles(Family family, const std::array<Quantile, 2>& two) {
  const auto [first, second] = two;
  if (!(first.probability < second.probability) || !(first.value < second.value)) return std::nullopt;
  if (family == Family::uniform) {
    const double range = (second.value - first.value) / (second.probability - first.probability);
    const double least = first.value - first.probability * range;
    return Distribution{family, {least, least + range}};
  }
  if (family != Family::normal && family != Family::lognormal) return std::nullopt;
  const bool logarithm = family == Family::lognormal;
  if (logarithm && !(first.value > 0.0)) return std::nullopt;
  const double a = logarithm ? std::log(first.value) : first.value;
  const double b = logarithm ? std::log(second.value) : second.value;
  const double score_a = normal_score(first.probability), score_b = normal_score(second.probability);
  const double deviation = (b - a) / (score_b - score_a);
  return Distribution{family, {a - score_a * deviation, deviation}};
}

double most_deviation(double least, double most, double mean) {
  return std::sqrt((mean - least) * (most - mean));
}

std::optional<Distribution> beta_from_moments(double least, double most, double mean, double deviation) {
  if (!(least < mean) || !(mean < most) || !(deviation > 0.0)) return std::nullopt;
  if (!(deviation < most_deviation(least, most, mean))) return std::nullopt;
  const double place = (mean - least) / (most - least), spread = deviation / (most - least);
  const double sum = place * (1.0 - place) / (spread * spread) - 1.0;  // alpha + beta
  return Distribution{Family::beta, {place * sum, (1.0 - place) * sum, least, most}};
}

}  // namespace cpt::parameters

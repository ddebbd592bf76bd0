#include "parameters/designs/bootstrap.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <numeric>

namespace cpt::parameters {
namespace {

using Eigen::Index;

constexpr double confidence = 0.95;  // [-]

// Share of the draws below the interval's lower end.
double expanded_tail(Index units) {
  const auto n = static_cast<double>(units);
  const double t = quantile(boost::math::students_t(n - 1.0), 0.5 + 0.5 * confidence);
  return cdf(boost::math::normal(), -t * std::sqrt(n / (n - 1.0)));
}

// Linear between order statistics.
double percentile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

}  // namespace

std::vector<Estimate> bootstrap(Index units, int samples, std::uint64_t seed,
                                const std::function<Eigen::VectorXd(const Resample&)>& estimator) {
  Resample sample(static_cast<std::size_t>(units));
  std::iota(sample.begin(), sample.end(), Index{0});
  const Eigen::VectorXd values = estimator(sample);
  std::vector<Estimate> estimates(static_cast<std::size_t>(values.size()));
  for (Index q = 0; q < values.size(); ++q) estimates[static_cast<std::size_t>(q)].value = values(q);
  if (units < 3) return estimates;

  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_int_distribution<Index> unit(0, units - 1);
  std::vector<std::vector<double>> draws(estimates.size());
  for (int k = 0; k < samples; ++k) {
    std::generate(sample.begin(), sample.end(), [&] { return unit(bits); });
    const Eigen::VectorXd drawn = estimator(sample);
    for (Index q = 0; q < drawn.size(); ++q)
      if (std::isfinite(drawn(q))) draws[static_cast<std::size_t>(q)].push_back(drawn(q));
  }
  const double tail = expanded_tail(units);
  for (std::size_t q = 0; q < estimates.size(); ++q) {
    if (draws[q].size() * 10 < static_cast<std::size_t>(samples) * 9) continue;
    std::sort(draws[q].begin(), draws[q].end());
    estimates[q].lower = percentile(draws[q], tail);
    estimates[q].upper = percentile(draws[q], 1.0 - tail);
  }
  return estimates;
}

}  // namespace cpt::parameters

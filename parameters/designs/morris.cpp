#include "parameters/designs/morris.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <iterator>
#include <vector>

#include "parameters/designs/permutation.hpp"
#include "parameters/designs/variation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Trajectories x parameters; NaN for those that touch a run without a result.
MatrixXd effects_of(const MatrixXd& places, const VectorXd& y) {
  const Index parameters = places.cols(), trajectories = places.rows() / (parameters + 1);
  MatrixXd effects(trajectories, parameters);
  for (Index t = 0; t < trajectories; ++t)
    for (Index k = 0; k < parameters; ++k) {
      const Index run = t * (parameters + 1) + k;
      Index moved = 0;
      const VectorXd step = places.row(run + 1) - places.row(run);
      step.cwiseAbs().maxCoeff(&moved);
      const bool missing = std::isnan(y(run)) || std::isnan(y(run + 1));
      effects(t, moved) = missing                      ? undefined
                          : differ(y(run), y(run + 1)) ? (y(run + 1) - y(run)) / step(moved)
                                                       : 0.0;
    }
  return effects;
}

// mu, mu* and sigma of one parameter over a sample of its effects.
VectorXd moments(const VectorXd& effects, const Resample& sample) {
  double n = 0.0, sum = 0.0, sum_of_sizes = 0.0, squares = 0.0;
  for (const Index t : sample) {
    n += 1.0;
    sum += effects(t);
    sum_of_sizes += std::abs(effects(t));
  }
  for (const Index t : sample) squares += std::pow(effects(t) - sum / n, 2);
  return Eigen::Vector3d(n > 0.0 ? sum / n : undefined, n > 0.0 ? sum_of_sizes / n : undefined,
                         n > 1.0 ? std::sqrt(squares / (n - 1.0)) : undefined);
}

constexpr Index fewest_of_sigma = 5;

// The 95 % interval of a standard deviation of numbers of any distribution: normal in its logarithm, as wide
// as their kurtosis says, which is taken about a trimmed mean (Bonett 2006, eq. 2 to 4).
Estimate bonett_interval(const VectorXd& effects, double deviation) {
  const auto n = static_cast<double>(effects.size());
  if (effects.size() < fewest_of_sigma) return {deviation, undefined, undefined};
  if (deviation == 0.0) return {0.0, 0.0, 0.0};
  VectorXd sorted = effects / deviation;
  std::ranges::sort(sorted);
  const auto cut = static_cast<Index>(n / (2.0 * std::sqrt(n - 4.0)));
  const Index kept = effects.size() - 2 * cut;
  const double middle = kept > 0 ? sorted.segment(cut, kept).mean() : sorted.mean();
  const double kurtosis = n * (sorted.array() - middle).pow(4).sum() / ((n - 1.0) * (n - 1.0));
  const double z = quantile(boost::math::normal(), 0.975), c = n / (n - z);
  const double half = z * c * std::sqrt((kurtosis - (n - 3.0) / n) / (n - 1.0));
  return {deviation, deviation * std::sqrt(c * std::exp(-half)), deviation * std::sqrt(c * std::exp(half))};
}

}  // namespace

MatrixXd morris_places(int parameters, int trajectories, int levels, std::uint64_t seed) {
  boost::random::mt19937_64 bits(seed);
  boost::random::uniform_int_distribution<int> level(0, levels - 1);
  const int half = levels / 2;
  MatrixXd places(Index{trajectories} * (parameters + 1), parameters);
  Index run = 0;
  for (int t = 0; t < trajectories; ++t) {
    Eigen::VectorXi at(parameters);
    for (Index j = 0; j < parameters; ++j) at(j) = level(bits);
    const auto put = [&] { places.row(run++) = at.cast<double>().transpose() / (levels - 1); };
    put();
    for (const Index j : permutation(parameters, bits)) {
      at(j) += at(j) < half ? half : -half;
      put();
    }
  }
  return places;
}

std::vector<ElementaryEffects> elementary_effects(const MatrixXd& places, const VectorXd& y,
                                                  std::uint64_t seed) {
  const MatrixXd effects = effects_of(places, y);
  std::vector<ElementaryEffects> all;
  for (Index j = 0; j < effects.cols(); ++j) {
    const auto used = static_cast<int>(effects.col(j).array().isFinite().count());
    const auto dropped = static_cast<int>(effects.rows()) - used;
    if (is_constant(y)) {
      all.push_back({{}, {}, {}, used, dropped});
      continue;
    }
    std::vector<double> own;  // trajectories that say nothing of it are no units to draw
    std::ranges::copy_if(effects.col(j), std::back_inserter(own), [](double e) { return std::isfinite(e); });
    const Eigen::Map<const VectorXd> finite(own.data(), used);
    const auto estimates = bootstrap(used, bootstrap_draws, seed,
                                     [&](const Resample& sample) { return moments(finite, sample); });
    all.push_back({estimates[0], estimates[1], bonett_interval(finite, estimates[2].value), used, dropped});
  }
  return all;
}

DesignKind morris_design() {
  return {
      .name = "morris",
      // Morris (1991), Campolongo et al. (2007)
      .keys = {{"trajectories", 10.0}, {"levels", 4.0}, {"seed", 1.0}},
      .run_count = [](const Design& design) { return long{design.trajectories} * (width_of(design) + 1); },
      .places =
          [](const Design& design) {
            return morris_places(width_of(design), design.trajectories, design.levels, design.seed);
          },
      .run_name = [](const Design& design,
                     Index run) { return name_in_group("morris", run, width_of(design) + 1); }};
}

}  // namespace cpt::parameters

#include "parameters/designs/morris.hpp"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>

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

// mu, mu* and sigma of one parameter over a sample of its trajectories.
VectorXd moments(const VectorXd& effects, const Resample& sample) {
  double n = 0.0, sum = 0.0, sum_of_sizes = 0.0, squares = 0.0;
  for (const Index t : sample) {
    if (!std::isfinite(effects(t))) continue;
    n += 1.0;
    sum += effects(t);
    sum_of_sizes += std::abs(effects(t));
  }
  for (const Index t : sample)
    if (std::isfinite(effects(t))) squares += std::pow(effects(t) - sum / n, 2);
  return Eigen::Vector3d(n > 0.0 ? sum / n : undefined, n > 0.0 ? sum_of_sizes / n : undefined,
                         n > 1.0 ? std::sqrt(squares / (n - 1.0)) : undefined);
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
    const auto estimates = bootstrap(effects.rows(), bootstrap_draws, seed,
                                     [&](const Resample& sample) { return moments(effects.col(j), sample); });
    all.push_back({estimates[0], estimates[1], estimates[2], used, dropped});
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

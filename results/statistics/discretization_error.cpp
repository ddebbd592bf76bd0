#include "results/statistics/discretization_error.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "parameters/designs/variation.hpp"

namespace cpt::results {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double safety = 1.25;         // [-] for three meshes, Roache (1994)
constexpr double largest_order = 20.0;  // [-]

// ln of (r32^p - 1) / (1 - r21^-p): rises with p, from ln(ln r32 / ln r21) at p = 0.
double log_ratio(double p, double ln_r21, double ln_r32) {
  return std::log(std::expm1(p * ln_r32)) - std::log(-std::expm1(-p * ln_r21));
}

double observed_order(double ratio, double ln_r21, double ln_r32) {
  const auto rest = [&](double p) { return log_ratio(p, ln_r21, ln_r32) - std::log(ratio); };
  const double least = 1e-9;
  if (rest(largest_order) <= 0.0) return largest_order;
  if (rest(least) >= 0.0) return least;
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      rest, least, largest_order, boost::math::tools::eps_tolerance<double>(40), steps);
  return 0.5 * (low + high);
}

}  // namespace

DiscretizationError discretization_error(const std::array<MeshResult, 3>& meshes) {
  const auto& [fine, medium, coarse] = meshes;
  const double ln_r21 = std::log(medium.h / fine.h), ln_r32 = std::log(coarse.h / medium.h);
  const double e21 = medium.value - fine.value, e32 = coarse.value - medium.value;
  const auto [low, high] = std::minmax({fine.value, medium.value, coarse.value});
  if (!parameters::differ(low, high)) return {Convergence::constant, nan, nan, 0.0};
  if (e21 * e32 < 0.0 || !parameters::differ(fine.value, medium.value)) {
    return {Convergence::oscillatory, nan, nan, 0.5 * (high - low) / std::abs(fine.value)};
  }
  const double ratio = e32 / e21;
  if (!(ratio > ln_r32 / ln_r21)) return {Convergence::diverging, nan, nan, nan};
  const double p = observed_order(ratio, ln_r21, ln_r32);
  const double believed = std::min(p, formal_order);
  const double correction = -e21 / std::expm1(believed * ln_r21);
  return {Convergence::monotone, p, fine.value + correction, safety * std::abs(correction / fine.value)};
}

}  // namespace cpt::results

#include "solver/soils/random_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/hashed.hpp"

namespace cpt::solver {
namespace {

constexpr double node_spacing = 1.0e-3;     // [m]
constexpr std::uint64_t last_node = 65536;  // a power of two

// Standard normal (Box & Muller 1958), one for each node of each seed.
double normal_of(std::uint64_t seed, std::uint64_t node) {
  const std::uint64_t own = hashed(seed) + 2 * node;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - hashed_unit(own)));
  return radius * std::cos(2.0 * std::numbers::pi * hashed_unit(own + 1));
}

// g at a node: of the interval around it both ends are known, and its middle follows, until the node is met.
double at_node(std::uint64_t seed, std::uint64_t node, double length) {
  std::uint64_t low = 0, high = last_node;
  const double across = std::exp(-node_spacing * static_cast<double>(last_node) / length);
  double left = normal_of(seed, low);
  double right = across * left + std::sqrt(1.0 - across * across) * normal_of(seed, high);
  while (node != low && node != high) {
    const std::uint64_t middle = (low + high) / 2;
    const double rho = std::exp(-node_spacing * static_cast<double>(middle - low) / length);
    const double share = 1.0 + rho * rho;
    const double value =
        rho / share * (left + right) + std::sqrt((1.0 - rho * rho) / share) * normal_of(seed, middle);
    (node < middle ? high : low) = middle;
    (node < middle ? right : left) = value;
  }
  return node == low ? left : right;
}

}  // namespace

double RandomField::score(double depth) const {
  const double place = std::clamp(depth / node_spacing, 0.0, static_cast<double>(last_node - 1));
  const auto above = static_cast<std::uint64_t>(place);
  const auto own = static_cast<std::uint64_t>(seed);
  return std::lerp(at_node(own, above, length), at_node(own, above + 1, length),
                   place - static_cast<double>(above));
}

double RandomField::at(double mean, double depth) const {
  if (!on()) return mean;
  if (kind == FieldKind::normal) return mean + deviation * score(depth);
  const double zeta2 = std::log1p(deviation * deviation / (mean * mean));
  return mean * std::exp(std::sqrt(zeta2) * score(depth) - 0.5 * zeta2);
}

}  // namespace cpt::solver

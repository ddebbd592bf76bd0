#include "validation/concealed/outside_effect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace cpt::validation::concealed {
namespace {

constexpr std::array<std::string_view, 5> effect_names = {"stone", "laminae", "zero jump", "stuck", "pauses"};
constexpr double recovery = 0.008;  // [m] of q_c after a pause

double between(diagnosis::Random& random, double lower, double upper) {
  return lower + random.uniform() * (upper - lower);
}

double signed_between(diagnosis::Random& random, double lower, double upper) {
  const double size = between(random, lower, upper);
  return random.uniform() < 0.5 ? -size : size;
}

}  // namespace

std::span<const std::string_view> outside_kinds() { return effect_names; }

const solver::Mechanism* catalogued(const OutsideEffect& effect) {
  std::string name = effect.kind;
  std::ranges::replace(name, ' ', '_');
  return solver::find_mechanism(name);
}

OutsideEffect draw_outside(std::string_view kind, double from, double to, diagnosis::Random& random) {
  OutsideEffect effect{std::string(kind), 0.0, 0.0, 0.0};
  effect.depth = between(random, from, to);
  if (kind == "stone") {
    effect.size = between(random, 0.05, 0.8);
    effect.length = between(random, 0.005, 0.015);
  } else if (kind == "laminae") {
    effect.size = between(random, 0.02, 0.2);
    effect.length = between(random, 0.03, 0.08);
  } else if (kind == "zero jump") {
    effect.size = signed_between(random, 0.05, 0.4);
  } else if (kind == "stuck") {
    effect.size = 1.0;
    effect.length = between(random, 0.01, 0.05);
  } else if (kind == "pauses") {
    effect.size = between(random, 0.05, 0.5);
    effect.length = between(random, 0.04, 0.08);
    effect.depth = from + random.uniform() * effect.length;
  } else {
    throw std::invalid_argument("no such effect: " + std::string(kind));
  }
  return effect;
}

std::vector<double> with_outside(const OutsideEffect& effect, std::span<const double> depth,
                                 std::span<const double> q_c) {
  const double mean = std::accumulate(q_c.begin(), q_c.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(1, q_c.size()));
  const auto changed = [&](double z, double q) {
    const double x = z - effect.depth;
    if (effect.kind == "stone")
      return q * (1.0 + effect.size * std::exp(-0.5 * x * x / (effect.length * effect.length)));
    if (effect.kind == "laminae")
      return q * (1.0 + effect.size * std::sin(2.0 * std::numbers::pi * x / effect.length));
    if (effect.kind == "zero jump") return x > 0.0 ? q + effect.size * mean : q;
    if (effect.kind == "gain drift") return q * (1.0 + effect.size * (z - depth.front()) / effect.length);
    if (effect.kind == "zero drift") return q + effect.size * mean * (z - depth.front()) / effect.length;
    if (effect.kind == "zero offset") return q + effect.size * mean;
    if (effect.kind == "pauses") {
      if (x < 0.0) return q;
      const double since = x - effect.length * std::floor(x / effect.length);
      return q * (1.0 - effect.size * std::exp(-since / recovery));
    }
    throw std::invalid_argument("no such effect: " + effect.kind);
  };
  std::vector<double> result(q_c.size());
  if (effect.kind == "stuck") {
    for (std::size_t i = 0; i < q_c.size(); ++i) {
      const bool jammed = i > 0 && depth[i] > effect.depth && depth[i] <= effect.depth + effect.length;
      result[i] = jammed ? result[i - 1] : q_c[i];
    }
    return result;
  }
  for (std::size_t i = 0; i < q_c.size(); ++i) result[i] = std::max(1e3, changed(depth[i], q_c[i]));
  return result;
}

}  // namespace cpt::validation::concealed

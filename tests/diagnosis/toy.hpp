// A sounding of 60 cells with noise of known covariance, two parameters and a few mechanisms by formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/covariance.hpp"
#include "diagnosis/curve_emulator.hpp"
#include "diagnosis/parameters_prior.hpp"
#include "diagnosis/random.hpp"

namespace cpt::diagnosis::toy {

inline std::vector<Cell> cells(int soundings = 1, int count = 60) {
  return cells_of(std::vector<SoundingGrid>(static_cast<std::size_t>(soundings), {0.0, 0.01, count}));
}

inline const NoiseModel noise{Kernel::ar1, 0.03, 0.03};

template <class Function>
VectorXd curve(const std::vector<Cell>& cells, Function f) {
  VectorXd y(static_cast<Index>(cells.size()));
  for (Index i = 0; i < y.size(); ++i) y(i) = f(cells[static_cast<std::size_t>(i)].depth);
  return y;
}

inline VectorXd baseline(const std::vector<Cell>& cells) {
  return curve(cells, [](double z) { return std::log(2.0e6 + 5.0e6 * z); });
}

// A parameter that scales the curve by +-10 %, and one that tilts it, more to one side than to the other.
inline std::vector<ParameterEffect> parameters(const std::vector<Cell>& cells) {
  const VectorXd y = baseline(cells);
  const auto shifted = [&](double constant, double tilt) -> VectorXd {
    return y + curve(cells, [&](double z) { return constant + tilt * (z - 0.3); });
  };
  return {{"scale", 0.5, shifted(-0.1, 0.0), shifted(0.1, 0.0)},
          {"tilt", 0.4, shifted(0.0, -0.2), shifted(0.02, 0.4)}};
}

inline NullModel null(const std::vector<Cell>& cells) {
  return null_model(ResponseSurface(baseline(cells), parameters(cells)), noise_covariance(cells, noise));
}

// The sequence of van der Corput: evenly spread over [0, 1).
inline double spread(int i, int base) {
  double x = 0.0;
  for (double digit = 1.0 / base; i > 0; i /= base, digit /= base) x += digit * (i % base);
  return x;
}

/// Runs of truth(phi_0, phi_1) over a Halton design; with one parameter phi_1 = 0.
template <class Truth>
MechanismEffect effect(const std::string& name, const std::vector<std::string>& parameters, int runs,
                       Truth truth) {
  const auto dimensions = static_cast<Index>(parameters.size());
  MechanismEffect result{name, parameters, MatrixXd(runs, dimensions), {}, true};
  for (int i = 0; i < runs; ++i) {
    for (Index d = 0; d < dimensions; ++d) result.design(i, d) = spread(i + 1, d == 0 ? 2 : 3);
    const VectorXd delta = truth(result.design(i, 0), dimensions > 1 ? result.design(i, 1) : 0.0);
    if (i == 0) result.delta.resize(delta.size(), runs);
    result.delta.col(i) = delta;
  }
  return result;
}

inline double bump(double x) { return std::exp(-0.5 * x * x); }

// A hard layer of 6 cm at some depth.
inline VectorXd lens_curve(const std::vector<Cell>& cells, double strength, double depth) {
  return curve(cells, [&](double z) { return 0.5 * strength * bump((z - 0.15 - 0.3 * depth) / 0.04); });
}
inline MechanismEffect lens(const std::vector<Cell>& cells, int runs) {
  return effect("lens", {"strength", "depth"}, runs,
                [&](double a, double b) { return lens_curve(cells, a, b); });
}

// A step near the top that decays with depth.
inline VectorXd top_curve(const std::vector<Cell>& cells, double strength, double reach) {
  return curve(cells, [&](double z) { return -0.6 * strength * std::exp(-z / (0.03 + 0.1 * reach)); });
}
inline MechanismEffect top(const std::vector<Cell>& cells, int runs) {
  return effect("top", {"strength", "reach"}, runs,
                [&](double a, double b) { return top_curve(cells, a, b); });
}

// A growth with depth that ends in a plateau.
inline VectorXd drift_curve(const std::vector<Cell>& cells, double strength) {
  return curve(cells, [&](double z) { return 0.5 * strength / (1.0 + std::exp(-(z - 0.35) / 0.03)); });
}
inline MechanismEffect drift(const std::vector<Cell>& cells, int runs) {
  return effect("drift", {"strength"}, runs, [&](double a, double) { return drift_curve(cells, a); });
}

// A factor for all depths, as far as half of what the parameter "scale" may do.
inline MechanismEffect scaling(const std::vector<Cell>& cells, int runs) {
  return effect("scaling", {"strength"}, runs, [&](double a, double) -> VectorXd {
    return VectorXd::Constant(static_cast<Index>(cells.size()), 0.1 * a);
  });
}

}  // namespace cpt::diagnosis::toy

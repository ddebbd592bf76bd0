// A sounding of 60 cells with noise of known covariance, two parameters and a few mechanisms by formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/covariance.hpp"
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
  return null_model(AdditiveModel(baseline(cells), parameters(cells)), noise_covariance(cells, noise));
}

}  // namespace cpt::diagnosis::toy

// Which of all fields a random field is: a whole number that every realization draws.
#pragma once

#include <algorithm>
#include <cmath>

#include "parameters/distributions/distribution.hpp"

namespace cpt::parameters {

/// 1 to 2^32, all alike.
class FieldSeed final : public Marginal {
 public:
  static constexpr double count = 4294967296.0;
  [[nodiscard]] double quantile(double probability) const override {
    return 1.0 + std::floor(std::clamp(probability, 0.0, 1.0) * (count - 1.0));
  }
  [[nodiscard]] double probability(double value) const override {
    return std::clamp(std::floor(value) / count, 0.0, 1.0);
  }
  [[nodiscard]] double mean() const override { return 0.5 * (count + 1.0); }
  [[nodiscard]] double standard_deviation() const override { return std::sqrt((count * count - 1.0) / 12.0); }
};

}  // namespace cpt::parameters

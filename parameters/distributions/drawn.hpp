// What every run of a design draws for itself, and no one-at-a-time run changes.
#pragma once

#include <algorithm>
#include <cmath>

#include "parameters/distributions/distribution.hpp"

namespace cpt::parameters {

/// Which of all fields a random field is: a whole number from 1 to 2^32, all alike.
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

/// Where the material points lie about their grid (numerics.point_shift): -0.5 to 0.5 of their spacing.
class PointShift final : public Marginal {
 public:
  [[nodiscard]] double quantile(double probability) const override {
    return std::clamp(probability, 0.0, 1.0) - 0.5;
  }
  [[nodiscard]] double probability(double value) const override { return std::clamp(value + 0.5, 0.0, 1.0); }
  [[nodiscard]] double mean() const override { return 0.0; }
  [[nodiscard]] double standard_deviation() const override { return std::sqrt(1.0 / 12.0); }
};

}  // namespace cpt::parameters

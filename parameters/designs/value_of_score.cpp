#include "parameters/designs/value_of_score.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "parameters/designs/design.hpp"

namespace cpt::parameters {
namespace {

constexpr int half = 1200;
constexpr double step = 0.005;  // to scores of 6: one in a thousand million

}  // namespace

double probability_of_score(double score) { return 0.5 * std::erfc(-score / std::numbers::sqrt2); }

double score_of_probability(double probability) {
  constexpr double edge = 1e-12;
  return boost::math::quantile(boost::math::normal_distribution<double>(),
                               std::clamp(probability, edge, 1.0 - edge));
}

ValueOfScore::ValueOfScore(const Row& row) {
  for (int k = 0; k <= 2 * half; ++k)
    values_.push_back(value_of_probability(row, probability_of_score((k - half) * step)));
  const auto middle = values_.begin() + half;
  steps_ = std::adjacent_find(middle - half / 2, middle + half / 2) != middle + half / 2;
}

double ValueOfScore::operator()(double score) const {
  const double place = std::clamp(score / step + half, 0.0, 2.0 * half);
  const auto below = static_cast<std::size_t>(steps_ ? std::round(place) : std::floor(place));
  if (steps_ || below + 1 >= values_.size()) return values_[below];
  return std::lerp(values_[below], values_[below + 1], place - static_cast<double>(below));
}

}  // namespace cpt::parameters

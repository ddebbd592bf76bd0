#include "results/statistics/repeat_noise.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "parameters/designs/variation.hpp"

namespace cpt::results {
namespace {

constexpr double confidence = 0.95;  // [-]

}  // namespace

double student_t(double freedom) {
  return quantile(boost::math::students_t(freedom), 0.5 + 0.5 * confidence);
}

std::optional<RepeatNoise> repeat_noise(std::span<const double> numbers) {
  if (numbers.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(numbers.size());
  double mean = 0.0, squares = 0.0;
  for (const double number : numbers) mean += number / n;
  for (const double number : numbers) squares += (number - mean) * (number - mean);
  const auto [least, largest] = std::ranges::minmax(numbers);
  const double deviation = parameters::differ(least, largest) ? std::sqrt(squares / (n - 1.0)) : 0.0;
  return RepeatNoise{static_cast<int>(numbers.size()), mean, deviation};
}

double prediction_half_width(const RepeatNoise& noise) {
  return student_t(noise.runs - 1) * noise.deviation * std::sqrt(1.0 + 1.0 / noise.runs);
}

double index_half_width(const RepeatNoise& noise) {
  return student_t(noise.runs - 1) * noise.deviation * std::sqrt(2.0) / noise.mean;
}

double paired_half_width(std::span<const double> indices) {
  const auto noise = repeat_noise(indices);
  return noise ? student_t(noise->runs - 1) * noise->deviation : std::numeric_limits<double>::quiet_NaN();
}

double index_half_width(const RepeatNoise& noise, double q_lower, double q_upper) {
  return index_half_width(noise) * std::abs(q_lower / q_upper);
}

}  // namespace cpt::results

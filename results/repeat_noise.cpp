#include "results/repeat_noise.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace cpt::results {
namespace {

constexpr double confidence = 0.95;  // [-]

double student_t(int freedom) { return quantile(boost::math::students_t(freedom), 0.5 + 0.5 * confidence); }

}  // namespace

std::optional<RepeatNoise> repeat_noise(std::span<const double> numbers) {
  if (numbers.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(numbers.size());
  double mean = 0.0, squares = 0.0;
  for (const double number : numbers) mean += number / n;
  for (const double number : numbers) squares += (number - mean) * (number - mean);
  return RepeatNoise{static_cast<int>(numbers.size()), mean, std::sqrt(squares / (n - 1.0))};
}

double prediction_half_width(const RepeatNoise& noise) {
  return student_t(noise.runs - 1) * noise.deviation * std::sqrt(1.0 + 1.0 / noise.runs);
}

double index_half_width(const RepeatNoise& noise) {
  return student_t(noise.runs - 1) * noise.deviation * std::sqrt(2.0) / noise.mean;
}

}  // namespace cpt::results

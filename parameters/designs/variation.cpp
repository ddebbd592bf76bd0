#include "parameters/designs/variation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cpt::parameters {

bool differ(double a, double b) {
  return std::abs(a - b) > rounding_share * std::max(std::abs(a), std::abs(b));
}

bool varies(const Eigen::VectorXd& numbers) {
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    least = std::min(least, number);
    largest = std::max(largest, number);
  }
  return least < largest && differ(least, largest);
}

bool is_constant(const Eigen::VectorXd& numbers) {
  return numbers.array().isFinite().count() >= 2 && !varies(numbers);
}

}  // namespace cpt::parameters

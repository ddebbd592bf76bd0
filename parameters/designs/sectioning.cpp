#include "parameters/designs/sectioning.hpp"

#include <Eigen/Core>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace cpt::parameters {

Estimate sectioned(double value, std::span<const double> own) {
  Estimate estimate;
  estimate.value = value;
  double squares = 0.0;
  int sections = 0;
  for (const double number : own) {
    if (!std::isfinite(number)) continue;
    squares += std::pow(number - value, 2);
    ++sections;
  }
  if (sections < least_sections || !std::isfinite(value)) return estimate;
  const boost::math::students_t_distribution<double> student(sections - 1);
  const double half =
      boost::math::quantile(student, 0.975) * std::sqrt(squares / (sections * (sections - 1.0)));
  estimate.lower = value - half;
  estimate.upper = value + half;
  return estimate;
}

double jackknife_half_width(std::span<const double> left_out) {
  const Eigen::Map<const Eigen::ArrayXd> numbers(left_out.data(), static_cast<Eigen::Index>(left_out.size()));
  const auto k = static_cast<double>(left_out.size());
  const double squares = (numbers - numbers.mean()).square().sum();
  const boost::math::students_t_distribution<double> student(k - 1.0);
  return boost::math::quantile(student, 0.975) * std::sqrt((k - 1.0) / k * squares);
}

Estimate jackknifed(double value, const Eigen::RowVectorXd& left_out) {
  const double half = jackknife_half_width({left_out.data(), static_cast<std::size_t>(left_out.size())});
  if (!std::isfinite(half)) return {value, half, half};
  return {value, value - half, value + half};
}

}  // namespace cpt::parameters

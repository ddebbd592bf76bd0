#include "parameters/designs/propagation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int fewest_sections = 5;  // that an interval rests on

// Entries that are numbers; of one section, or of all (-1).
VectorXd entries(const VectorXd& y, Index section) {
  std::vector<double> found;
  for (Index i = 0; i < y.size(); ++i)
    if (!std::isnan(y(i)) && (section < 0 || i % propagation_sections == section)) found.push_back(y(i));
  return Eigen::Map<const VectorXd>(found.data(), static_cast<Index>(found.size()));
}

}  // namespace

MatrixXd propagation_places(int parameters, int runs, std::uint64_t seed) {
  boost::random::mt19937_64 bits(seed);
  std::vector<std::vector<std::uint64_t>> shifts(propagation_sections);
  for (auto& shift : shifts)
    for (int j = 0; j < parameters; ++j) shift.push_back(bits());

  boost::random::sobol sequence(static_cast<std::size_t>(parameters));
  std::vector<std::uint64_t> digits(static_cast<std::size_t>(parameters),
                                    0);  // Boost leaves the zero point out
  MatrixXd places(runs, parameters);
  for (Index run = 0; run < runs; ++run) {
    const auto section = static_cast<std::size_t>(run % propagation_sections);
    if (section == 0 && run > 0)
      for (std::uint64_t& word : digits) word = sequence();
    for (std::size_t j = 0; j < digits.size(); ++j)
      places(run, static_cast<Index>(j)) =
          (static_cast<double>((digits[j] ^ shifts[section][j]) >> 12) + 0.5) * 0x1p-52;
  }
  return places;
}

Estimate by_sections(const VectorXd& y, int least, const std::function<double(const VectorXd&)>& number) {
  const VectorXd all = entries(y, -1);
  if (all.size() == 0) return {};
  Estimate estimate;
  estimate.value = number(all);
  double squares = 0.0;
  int sections = 0;
  for (Index section = 0; section < propagation_sections; ++section) {
    const VectorXd own = entries(y, section);
    if (own.size() < least) continue;
    squares += std::pow(number(own) - estimate.value, 2);
    ++sections;
  }
  if (sections < fewest_sections) return estimate;
  const boost::math::students_t_distribution<double> student(sections - 1);
  const double half =
      boost::math::quantile(student, 0.975) * std::sqrt(squares / (sections * (sections - 1.0)));
  if (!std::isfinite(half)) return estimate;
  estimate.lower = estimate.value - half;
  estimate.upper = estimate.value + half;
  return estimate;
}

double sample_deviation(const VectorXd& sample) {
  const double mean = sample.mean();
  return std::sqrt((sample.array() - mean).square().sum() / static_cast<double>(sample.size() - 1));
}

double sample_quantile(const VectorXd& sample, double probability) {
  VectorXd sorted = sample;
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  const double place = std::clamp((n + 1.0 / 3.0) * probability + 1.0 / 3.0, 1.0, n);  // from 1
  const auto below = static_cast<Index>(place) - 1;
  return std::lerp(sorted(below), sorted(std::min(below + 1, sorted.size() - 1)), place - std::floor(place));
}

DesignKind propagation_design() {
  return {
      .name = "propagation",
      .keys = {{"runs", 100.0}, {"seed", 1.0}},
      .samples = true,
      .dependent = true,
      .run_count = [](const Design& design) { return long{design.runs}; },
      .places =
          [](const Design& design) { return propagation_places(width_of(design), design.runs, design.seed); },
      .run_name = [](const Design&, Index run) { return fmt::format("propagation {}", run + 1); }};
}

}  // namespace cpt::parameters

#include "parameters/designs/propagation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <vector>

#include "parameters/designs/permutation.hpp"
#include "parameters/designs/sectioning.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Entries that are numbers and belong to a section that `wanted` takes.
template <class Wanted>
VectorXd entries(const VectorXd& y, bool latin, Wanted wanted) {
  std::vector<double> found;
  for (Index i = 0; i < y.size(); ++i)
    if (!std::isnan(y(i)) && wanted(section_of(i, latin))) found.push_back(y(i));
  return Eigen::Map<const VectorXd>(found.data(), static_cast<Index>(found.size()));
}
VectorXd all_entries(const VectorXd& y) {
  return entries(y, false, [](int) { return true; });
}

// Standard normal numbers at the middles of equally likely parts, of mean zero and variance one.
VectorXd normal_parts() {
  constexpr Index parts = 21;
  VectorXd score(parts);
  for (Index k = 0; k < parts; ++k)
    score(k) = boost::math::quantile(boost::math::normal(), (static_cast<double>(k) + 0.5) / parts);
  return score / std::sqrt(score.squaredNorm() / parts);
}

VectorXd with_error(const VectorXd& sample, double error) {
  static const VectorXd score = normal_parts();
  return (sample * (1.0 + error * score.array()).matrix().transpose()).reshaped();
}

Estimate clopper_pearson(double above, double runs) {
  using Binomial = boost::math::binomial_distribution<double>;
  constexpr double tail = 0.025;
  return {above / runs, Binomial::find_lower_bound_on_p(runs, above, tail),
          Binomial::find_upper_bound_on_p(runs, above, tail)};
}

}  // namespace

int section_of(Index run, bool latin) {
  return static_cast<int>((latin ? run / latin_runs : run) % propagation_sections);
}

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

// Each hypercube cuts the range of every input into ten equal intervals and goes once into each of them.
MatrixXd latin_places(int parameters, int runs, std::uint64_t seed) {
  boost::random::mt19937_64 bits(seed);
  MatrixXd places(runs, parameters);
  for (Index first = 0; first < runs; first += latin_runs)
    for (Index j = 0; j < parameters; ++j) {
      const std::vector<Index> order = permutation(latin_runs, bits);
      for (Index k = 0; k < latin_runs; ++k) {
        const double inside = (static_cast<double>(bits() >> 12) + 0.5) * 0x1p-52;
        if (first + k < runs)
          places(first + k, j) =
              (static_cast<double>(order[static_cast<std::size_t>(k)]) + inside) / latin_runs;
      }
    }
  return places;
}

Estimate by_sections(const VectorXd& y, int least, const std::function<double(const VectorXd&)>& number,
                     bool latin) {
  const VectorXd all = all_entries(y);
  if (all.size() == 0) return {};
  std::vector<double> of_sections;
  for (int section = 0; section < propagation_sections; ++section) {
    const VectorXd own = entries(y, latin, [&](int of) { return of == section; });
    if (own.size() >= least) of_sections.push_back(number(own));
  }
  return sectioned(number(all), of_sections);
}

Estimate exceedance(const VectorXd& y, bool latin, double threshold, double error) {
  constexpr double least_on_a_side = 5.0;
  const auto above = [=](const VectorXd& sample) {
    double sum = 0.0;
    for (const double value : sample)
      sum += error > 0.0 && value != 0.0
                 ? boost::math::cdf(boost::math::normal(), (value - threshold) / (error * std::abs(value)))
                 : (value > threshold ? 1.0 : 0.0);
    return sum;
  };
  const VectorXd all = all_entries(y);
  const auto runs = static_cast<double>(all.size());
  if (all.size() == 0) return {};
  if (above(all) < least_on_a_side || runs - above(all) < least_on_a_side)
    return clopper_pearson(above(all), runs);
  Estimate share = by_sections(
      y, 1, [&](const VectorXd& sample) { return above(sample) / static_cast<double>(sample.size()); },
      latin);
  if (share.lower == share.upper) return clopper_pearson(above(all), runs);  // all sections happen to agree
  share.lower = std::max(share.lower, 0.0);                                  // NaN stays NaN
  share.upper = std::min(share.upper, 1.0);
  return share;
}

bool suffices(const StopRule& rule, const VectorXd& y, Index runs, bool latin, double error) {
  const bool of_mean = std::isnan(rule.quantile);
  const auto of = [&](const VectorXd& sample) {
    return of_mean ? sample.mean() : sample_quantile(sample, rule.quantile, error);
  };
  const Estimate number = by_sections(y.head(runs), of_mean ? 1 : 2, of, latin);
  return number.upper - number.value <= rule.half_width * std::abs(number.value);
}

double sample_deviation(const VectorXd& sample, double error) {
  const double mean = sample.mean();
  const double square = (sample.array() - mean).square().sum() / static_cast<double>(sample.size() - 1);
  return std::sqrt(square + error * error * sample.array().square().mean());
}

double sample_quantile(const VectorXd& sample, double probability, double error) {
  VectorXd values = error > 0.0 ? with_error(sample, error) : sample;
  const auto n = static_cast<double>(values.size());
  const double place = std::clamp((n + 1.0 / 3.0) * probability + 1.0 / 3.0, 1.0, n);  // from 1
  const auto below = values.begin() + (static_cast<Index>(place) - 1);
  std::nth_element(values.begin(), below, values.end());
  const auto above = below + 1 == values.end() ? below : std::min_element(below + 1, values.end());
  return std::lerp(*below, *above, place - std::floor(place));
}

DesignKind propagation_design() {
  return {.name = "propagation",
          .keys = {{"runs", 100.0}, {"seed", 1.0}},
          .samples = true,
          .dependent = true,
          .draws_fields = true,
          .propagates = true,
          .run_count = [](const Design& design) { return long{design.runs}; },
          .places =
              [](const Design& design) {
                return (design.latin ? latin_places : propagation_places)(width_of(design), design.runs,
                                                                          design.seed);
              },
          .run_name = [](const Design&, Index run) { return fmt::format("propagation {}", run + 1); }};
}

}  // namespace cpt::parameters

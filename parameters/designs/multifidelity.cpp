#include "parameters/designs/multifidelity.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <numeric>

#include "parameters/designs/propagation.hpp"

namespace cpt::parameters {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index fewest_paired = 10;

// Results of one model, of the runs that it shares with the one before it and of all its own.
struct Level {
  VectorXd paired;  // with all others: for the weights
  VectorXd shared, own;
};

// Without a section (-1: with all). A run counts for a level where it has a result of it.
std::vector<Level> without_section(const Levels& levels, int section, bool latin) {
  const auto has = [&](std::size_t level, Index run) {
    return run < levels[level].size() && std::isfinite(levels[level](run));
  };
  const auto taken = [&](std::size_t level, auto wanted) {
    std::vector<double> found;
    for (Index run = 0; run < levels[level].size(); ++run)
      if (section_of(run, latin) != section && has(level, run) && wanted(run))
        found.push_back(levels[level](run));
    return VectorXd(Eigen::Map<const VectorXd>(found.data(), static_cast<Index>(found.size())));
  };
  std::vector<Level> all;
  for (std::size_t level = 0; level < levels.size(); ++level)
    all.push_back({taken(level,
                         [&](Index run) {
                           for (std::size_t other = 0; other < levels.size(); ++other)
                             if (!has(other, run)) return false;
                           return true;
                         }),
                   taken(level, [&](Index run) { return level > 0 && has(level - 1, run); }),
                   taken(level, [](Index) { return true; })});
  return all;
}

double covariance(const VectorXd& a, const VectorXd& b) {
  return ((a.array() - a.mean()) * (b.array() - b.mean())).sum() / static_cast<double>(a.size() - 1);
}

// How much of a cheaper model's change is the dearest one's; none where the cheaper one does not vary.
double weight(const VectorXd& dearest, const VectorXd& cheaper) {
  const double variance = covariance(cheaper, cheaper);
  return variance > 0.0 ? covariance(dearest, cheaper) / variance : 0.0;
}

using Each = std::function<VectorXd(std::size_t level, const VectorXd&)>;

// The mean of a function of each result.
double combined(const std::vector<Level>& levels, const Each& of) {
  double sum = of(0, levels[0].own).mean();
  const VectorXd dearest = of(0, levels[0].paired);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    if (levels[l].shared.size() == 0) continue;
    sum += weight(dearest, of(l, levels[l].paired)) *
           (of(l, levels[l].own).mean() - of(l, levels[l].shared).mean());
  }
  return sum;
}

double mean_of(const std::vector<Level>& levels) {
  return combined(levels, [](std::size_t, const VectorXd& y) { return y; });
}

double deviation_of(const std::vector<Level>& levels) {
  const double mean = mean_of(levels);
  const double variance = combined(levels, [&](std::size_t level, const VectorXd& y) -> VectorXd {
    return (y.array() - (level == 0 ? mean : levels[level].own.mean())).square();
  });
  return std::sqrt(std::max(variance, 0.0));
}

double quantile_of(std::vector<Level> levels, double probability) {
  const VectorXd dearest = levels[0].paired;
  std::vector<double> candidates(levels[0].own.begin(), levels[0].own.end());
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const double slope = weight(dearest, levels[l].paired);
    const double shift = dearest.mean() - slope * levels[l].paired.mean();
    for (VectorXd* y : {&levels[l].paired, &levels[l].shared, &levels[l].own})
      *y = (slope * y->array() + shift).matrix();
    candidates.insert(candidates.end(), levels[l].own.begin(), levels[l].own.end());
  }
  std::ranges::sort(candidates);
  const auto below = [&](double x) {
    return combined(
        levels, [x](std::size_t, const VectorXd& y) -> VectorXd { return (y.array() <= x).cast<double>(); });
  };
  // The share need not rise everywhere: it rises where all models' do, and the wiggles are those of few runs.
  std::size_t low = 0, high = candidates.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (below(candidates[middle]) >= probability)
      high = middle;
    else
      low = middle + 1;
  }
  return candidates[low];
}

Estimate jackknifed(const Levels& levels, bool latin,
                    const std::function<double(const std::vector<Level>&)>& number) {
  Estimate estimate;
  if (paired_runs(levels) < fewest_paired) return estimate;
  estimate.value = number(without_section(levels, -1, latin));
  std::vector<double> left;
  for (int section = 0; section < propagation_sections; ++section) {
    const std::vector<Level> others = without_section(levels, section, latin);
    if (others[0].own.size() == levels[0].size()) return estimate;
    left.push_back(number(others));
  }
  const auto k = static_cast<double>(left.size());
  const double mean = std::accumulate(left.begin(), left.end(), 0.0) / k;
  double squares = 0.0;
  for (const double one : left) squares += (one - mean) * (one - mean);
  const boost::math::students_t_distribution<double> student(k - 1.0);
  const double half = boost::math::quantile(student, 0.975) * std::sqrt((k - 1.0) / k * squares);
  estimate.lower = estimate.value - half;
  estimate.upper = estimate.value + half;
  return estimate;
}

}  // namespace

Index paired_runs(const Levels& levels) { return without_section(levels, -1, false)[0].paired.size(); }

double level_correlation(const Levels& levels, std::size_t cheaper) {
  const std::vector<Level> all = without_section(levels, -1, false);
  const VectorXd &a = all[0].paired, &b = all.at(cheaper).paired;
  return covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
}

Estimate combined_mean(const Levels& levels, bool latin) { return jackknifed(levels, latin, mean_of); }

Estimate combined_deviation(const Levels& levels, bool latin) {
  return jackknifed(levels, latin, deviation_of);
}

Estimate combined_quantile(const Levels& levels, double probability, bool latin) {
  return jackknifed(levels, latin,
                    [&](const std::vector<Level>& all) { return quantile_of(all, probability); });
}

double variance_ratio(double correlation, double cost_ratio) {
  const double rho = std::abs(correlation);
  return std::pow(std::sqrt(1.0 - rho * rho) + rho * std::sqrt(cost_ratio), 2);
}

double best_run_ratio(double correlation, double cost_ratio) {
  const double rho2 = correlation * correlation;
  return std::max(1.0, std::sqrt(rho2 / (cost_ratio * (1.0 - rho2))));
}

}  // namespace cpt::parameters

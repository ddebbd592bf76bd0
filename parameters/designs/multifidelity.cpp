#include "parameters/designs/multifidelity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "parameters/designs/propagation.hpp"
#include "parameters/designs/sectioning.hpp"

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

// Cheaper models brought to the dearest one's scale by the straight line through the paired runs.
std::vector<Level> to_one_scale(std::vector<Level> levels) {
  const VectorXd dearest = levels[0].paired;
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const double slope = weight(dearest, levels[l].paired);
    const double shift = dearest.mean() - slope * levels[l].paired.mean();
    for (VectorXd* y : {&levels[l].paired, &levels[l].shared, &levels[l].own})
      *y = (slope * y->array() + shift).matrix();
  }
  return levels;
}

// Of values on one scale: the probability of one not above x.
double share_below(const std::vector<Level>& levels, double x) {
  return combined(
      levels, [x](std::size_t, const VectorXd& y) -> VectorXd { return (y.array() <= x).cast<double>(); });
}

// The least value with that share. The share need not rise everywhere; where it falls, few runs are to blame.
double value_at_share(const std::vector<Level>& levels, double share) {
  std::vector<double> values;
  for (const Level& level : levels) values.insert(values.end(), level.own.begin(), level.own.end());
  std::ranges::sort(values);
  std::size_t low = 0, high = values.size() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (share_below(levels, values[middle]) >= share)
      high = middle;
    else
      low = middle + 1;
  }
  return values[low];
}

// Half the width of the 95 % interval of a number; NaN where some section has no runs of the dearest model.
double half_width(const Levels& levels, bool latin,
                  const std::function<double(const std::vector<Level>&)>& number) {
  std::vector<double> left;
  for (int section = 0; section < propagation_sections; ++section) {
    const std::vector<Level> others = without_section(levels, section, latin);
    if (others[0].own.size() == levels[0].size()) return std::numeric_limits<double>::quiet_NaN();
    left.push_back(number(others));
  }
  return jackknife_half_width(left);
}

Estimate jackknifed(const Levels& levels, bool latin,
                    const std::function<double(const std::vector<Level>&)>& number) {
  if (paired_runs(levels) < fewest_paired) return {};
  const double value = number(without_section(levels, -1, latin)), half = half_width(levels, latin, number);
  return {value, value - half, value + half};
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
  if (paired_runs(levels) < fewest_paired) return {};
  const std::vector<Level> all = to_one_scale(without_section(levels, -1, latin));
  const double value = value_at_share(all, probability);
  const double half = half_width(levels, latin, [value](const std::vector<Level>& others) {
    return share_below(to_one_scale(others), value);
  });
  if (std::isnan(half)) return {value, half, half};
  return {value, value_at_share(all, probability - half), value_at_share(all, probability + half)};
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

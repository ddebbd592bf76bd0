#include "diagnosis/several/answer.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace cpt::diagnosis {
namespace {

// Probability that at least one of the effects is at work.
double any_of(const Explained& explained, const std::vector<std::size_t>& effects) {
  double sum = 0.0;
  for (const WeighedSubset& weighed : explained.subsets)
    if (std::ranges::any_of(effects, [&](std::size_t effect) { return weighed.subset.has(effect); }))
      sum += weighed.probability;
  return sum;
}

double both_of(const Explained& explained, std::size_t a, std::size_t b) {
  double sum = 0.0;
  for (const WeighedSubset& weighed : explained.subsets)
    if (weighed.subset.has(a) && weighed.subset.has(b)) sum += weighed.probability;
  return sum;
}

// Effects more probable than not, but for those that rather stand in for each other than together.
std::vector<std::size_t> named_by(const Explained& explained, const NamingRules& rules) {
  constexpr double most_apart = 0.5;
  const auto inclusion = [&](std::size_t k) { return explained.inclusion(static_cast<Index>(k)); };
  std::vector<std::size_t> likely, named;
  for (std::size_t k = 0; k < static_cast<std::size_t>(explained.inclusion.size()); ++k)
    if (inclusion(k) > rules.named) likely.push_back(k);
  std::ranges::copy_if(likely, std::back_inserter(named), [&](std::size_t a) {
    return std::ranges::none_of(likely, [&](std::size_t b) {
      return b != a && both_of(explained, a, b) < most_apart * std::min(inclusion(a), inclusion(b));
    });
  });
  std::ranges::stable_sort(named, std::greater(), inclusion);
  return named;
}

// Among effects that are not named: the fewest, the most probable first, of which one is at work with the
// probability asked for. Effects that would have to be there together are no group: each must add what it has
// of its own.
std::vector<EffectGroup> groups_of(const Explained& explained, const std::vector<std::size_t>& named,
                                   const NamingRules& rules) {
  constexpr double least = 0.05, most_shared = 0.5;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < static_cast<std::size_t>(explained.inclusion.size()); ++k)
    if (std::ranges::find(named, k) == named.end() && explained.inclusion(static_cast<Index>(k)) > least)
      open.push_back(k);
  std::ranges::stable_sort(open, [&](std::size_t a, std::size_t b) {
    return explained.inclusion(static_cast<Index>(a)) > explained.inclusion(static_cast<Index>(b));
  });
  std::vector<EffectGroup> groups;
  std::vector<bool> taken(static_cast<std::size_t>(explained.inclusion.size()), false);
  for (const std::size_t first : open) {
    if (taken[first]) continue;
    EffectGroup group{{first}, any_of(explained, {first})};
    for (const std::size_t next : open) {
      if (group.probability >= rules.group) break;
      if (next == first || taken[next]) continue;
      std::vector<std::size_t> with = group.effects;
      with.push_back(next);
      const double probability = any_of(explained, with), own = explained.inclusion(static_cast<Index>(next));
      if (probability - group.probability < (1.0 - most_shared) * own) continue;
      group = {std::move(with), probability};
    }
    if (group.probability < rules.group) continue;
    for (const std::size_t member : group.effects) taken[member] = true;
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

Naming name_effects(const Explained& explained, bool alarm, double p, const NamingRules& rules) {
  Naming naming;
  naming.alarm = alarm;
  double held = 0.0;
  for (std::size_t s = 0; s < explained.subsets.size() && held < rules.credible; ++s) {
    held += explained.subsets[s].probability;
    naming.set.push_back(s);
  }
  if (!naming.alarm) return naming;
  if (p < rules.gate) {
    naming.something_else = true;
    return naming;
  }
  naming.something_else = explained.something_else > rules.named;
  naming.named = named_by(explained, rules);
  naming.groups = groups_of(explained, naming.named, rules);
  return naming;
}

double alarm_level(const SubsetWeigher& weigher, const MatrixXd& draws, double share) {
  std::vector<double> nothing;
  for (Index k = 0; k < draws.cols(); ++k) nothing.push_back(weigher.probability_of_nothing(draws.col(k)));
  const auto below =
      nothing.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(nothing.size()));
  std::nth_element(nothing.begin(), below, nothing.end());
  return *below;
}

}  // namespace cpt::diagnosis

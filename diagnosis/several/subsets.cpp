#include "diagnosis/several/subsets.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "diagnosis/quadrature.hpp"

namespace cpt::diagnosis {
namespace {

std::vector<Subset> all_subsets(std::size_t effects) {
  std::vector<Subset> all;
  const auto add = [&](std::vector<std::size_t> chosen) {
    all.push_back({chosen, false});
    if (chosen.size() < most_effects) all.push_back({std::move(chosen), true});
  };
  add({});
  for (std::size_t i = 0; i < effects; ++i) {
    add({i});
    for (std::size_t j = i + 1; j < effects; ++j) {
      add({i, j});
      for (std::size_t k = j + 1; k < effects; ++k) add({i, j, k});
    }
  }
  return all;
}

VectorXd log_priors(const std::vector<Subset>& subsets, std::size_t effects, const SubsetPrior& prior) {
  const double one =
      effects == 0 ? 0.0 : std::min(prior.most_probable, prior.expected / static_cast<double>(effects));
  VectorXd logs(static_cast<Index>(subsets.size()));
  for (std::size_t s = 0; s < subsets.size(); ++s) {
    const std::size_t count = subsets[s].effects.size();
    const double with = count < most_effects ? prior.something_else : 0.0;
    logs(static_cast<Index>(s)) = static_cast<double>(count) * std::log(one / (1.0 - one)) +
                                  std::log(subsets[s].something_else ? with : 1.0 - with);
  }
  return logs.array() - log_sum_exp(logs);
}

// Probabilities from prior and evidence, the most probable first.
void settle(std::vector<WeighedSubset>& subsets) {
  VectorXd logs(static_cast<Index>(subsets.size()));
  std::ranges::transform(subsets, logs.begin(),
                         [](const WeighedSubset& s) { return std::log(s.prior) + s.log_evidence; });
  const double total = log_sum_exp(logs);
  for (std::size_t s = 0; s < subsets.size(); ++s)
    subsets[s].probability = std::exp(logs(static_cast<Index>(s)) - total);
  std::ranges::stable_sort(subsets, std::greater(), &WeighedSubset::probability);
}

// Those that hold 99 %, the best first.
std::vector<Place> best_places(std::vector<Place> places, double log_evidence) {
  for (Place& place : places) place.probability = std::exp(place.combination.log_weight - log_evidence);
  std::ranges::stable_sort(places, std::greater(), &Place::probability);
  double held = 0.0;
  std::size_t kept = 0;
  while (kept < places.size() && held < 0.99) held += places[kept++].probability;
  places.resize(kept);
  return places;
}

}  // namespace

bool Subset::has(std::size_t effect) const { return std::ranges::find(effects, effect) != effects.end(); }

SubsetWeigher::SubsetWeigher(const std::vector<CurveEmulator>& effects, const MatrixXd& scatter,
                             const std::vector<Metric>& metrics, const Options& options)
    : options_(options), metrics_(metrics), subsets_(all_subsets(effects.size())) {
  for (const CurveEmulator& effect : effects) {
    coarse_.push_back(effect_nodes(effect, scatter, metrics.front().whitening, coarse_grid));
    fine_.push_back(effect_nodes(effect, scatter, metrics.front().whitening, fine_grid));
  }
  log_prior_ = log_priors(subsets_, effects.size(), options_.prior);
  prepare();
}

SubsetWeigher::SubsetWeigher(const SubsetWeigher& whole, const std::vector<Index>& rows)
    : options_(whole.options_), subsets_(whole.subsets_), log_prior_(whole.log_prior_) {
  for (const Metric& metric : whole.metrics_) metrics_.push_back(metric.on_rows(metric.covariance(), rows));
  for (const EffectNodes& nodes : whole.coarse_) coarse_.push_back(nodes.on_rows(rows));
  for (const EffectNodes& nodes : whole.fine_) fine_.push_back(nodes.on_rows(rows));
  prepare();
}

void SubsetWeigher::prepare() {
  std::vector<std::size_t> all(coarse_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const Metric& metric : metrics_) {
    coarse_combinations_.emplace_back(metric, coarse_);
    coarse_combinations_.back().prepare(all);
  }
}

std::vector<WeighedSubset> SubsetWeigher::first_look(const VectorXd& residual) const {
  std::vector<Target> target;
  for (const Combinations& look : coarse_combinations_) target.push_back(look.target(residual));
  std::vector<WeighedSubset> weighed;
  for (std::size_t s = 0; s < subsets_.size(); ++s) {
    std::vector<double> logs;
    for (std::size_t m = 0; m < metrics_.size(); ++m)
      if (metrics_[m].something_else() == subsets_[s].something_else)
        logs.push_back(metrics_[m].log_prior +
                       coarse_combinations_[m].log_evidence(target[m], subsets_[s].effects));
    const double evidence =
        log_sum_exp(Eigen::Map<const VectorXd>(logs.data(), static_cast<Index>(logs.size())));
    weighed.push_back({subsets_[s], std::exp(log_prior_(static_cast<Index>(s))), evidence, 0.0, {}});
  }
  settle(weighed);
  return weighed;
}

Combinations SubsetWeigher::at(std::size_t metric, std::span<const std::size_t> effects) const {
  Combinations look(metrics_[metric], fine_);
  look.prepare(effects);
  return look;
}

double SubsetWeigher::probability_of_nothing(const VectorXd& residual) const {
  for (const WeighedSubset& weighed : first_look(residual))
    if (weighed.subset.is_nothing()) return weighed.probability;
  return 0.0;
}

Explained SubsetWeigher::explain(const VectorXd& residual) const {
  Explained found;
  found.subsets = first_look(residual);
  const double floor = std::log(found.subsets.front().probability) - options_.fine_within;
  std::vector<WeighedSubset*> leading;
  for (std::size_t s = 0; s < found.subsets.size(); ++s) {
    WeighedSubset& weighed = found.subsets[s];
    const bool leads = s < options_.most_fine && std::log(weighed.probability) > floor;
    if (leads || weighed.subset.is_nothing()) leading.push_back(&weighed);
  }
  std::vector<std::vector<double>> logs(leading.size());
  std::vector<std::vector<Place>> places(leading.size());
  for (std::size_t m = 0; m < metrics_.size(); ++m) {
    Combinations look(metrics_[m], fine_);
    const auto asks = [&](const WeighedSubset* one) {
      return one->subset.something_else == metrics_[m].something_else();
    };
    for (const WeighedSubset* one : leading)
      if (asks(one)) look.prepare(one->subset.effects);
    const Target target = look.target(residual);
    for (std::size_t s = 0; s < leading.size(); ++s) {
      if (!asks(leading[s])) continue;
      std::vector<Combination> kept;
      logs[s].push_back(metrics_[m].log_prior + look.log_evidence(target, leading[s]->subset.effects, &kept));
      for (Combination& one : kept) {
        one.log_weight += metrics_[m].log_prior;
        places[s].push_back({m, one, 0.0});
      }
    }
  }
  for (std::size_t s = 0; s < leading.size(); ++s) {
    leading[s]->log_evidence =
        log_sum_exp(Eigen::Map<const VectorXd>(logs[s].data(), static_cast<Index>(logs[s].size())));
    leading[s]->places = best_places(std::move(places[s]), leading[s]->log_evidence);
  }
  settle(found.subsets);
  found.inclusion = VectorXd::Zero(static_cast<Index>(fine_.size()));
  for (const WeighedSubset& weighed : found.subsets) {
    for (const std::size_t effect : weighed.subset.effects)
      found.inclusion(static_cast<Index>(effect)) += weighed.probability;
    if (weighed.subset.something_else) found.something_else += weighed.probability;
    if (weighed.subset.is_nothing()) found.nothing = weighed.probability;
  }
  return found;
}

}  // namespace cpt::diagnosis

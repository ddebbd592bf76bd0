#include "diagnosis/several/summary.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <limits>
#include <map>

namespace cpt::diagnosis {
namespace {

// Of an effect's parameter: normals with weights.
struct Mixture {
  std::vector<double> weight, mean, deviation;

  [[nodiscard]] double below(double x) const {
    double sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < weight.size(); ++i) {
      sum += weight[i] * boost::math::cdf(boost::math::normal(mean[i], std::max(deviation[i], 1e-9)), x);
      all += weight[i];
    }
    return sum / all;
  }
  // By bisection in the unit interval, which it ends at.
  [[nodiscard]] double quantile(double probability) const {
    double lower = 0.0, upper = 1.0;
    for (int step = 0; step < 40; ++step)
      (below(0.5 * (lower + upper)) < probability ? lower : upper) = 0.5 * (lower + upper);
    return 0.5 * (lower + upper);
  }
};

class Summarizer {
 public:
  Summarizer(const SubsetWeigher& weigher, const VectorXd& residual, const MatrixXd& parameters, Index soil)
      : weigher_(weigher),
        residual_(residual),
        parameters_(parameters),
        normals_(VectorXd::Zero(soil)),
        squares_(MatrixXd::Zero(soil, soil)),
        effects_(weigher.fine().size()) {
    const Index n = residual.size();
    all_ = {VectorXd::Zero(n), VectorXd::Zero(n)};
    else_ = all_;
    soil_ = VectorXd::Zero(n);
    for (std::size_t k = 0; k < effects_.size(); ++k) {
      effects_[k].curve = VectorXd::Zero(n);
      effects_[k].parameters.resize(static_cast<std::size_t>(weigher.fine()[k].places.cols()));
    }
  }

  void add(const WeighedSubset& weighed, double probability) {
    for (const Place& place : weighed.places) add(weighed.subset, place, probability * place.probability);
  }

  Summary done() const {
    Summary summary;
    const auto band = [this](const Sums& sums) {
      const VectorXd mean = sums.first / weight_;
      return Band{mean, (sums.second / weight_ - mean.cwiseAbs2()).cwiseMax(0.0).cwiseSqrt()};
    };
    summary.effects = band(all_);
    summary.something_else = band(else_);
    summary.soil = soil_ / weight_;
    summary.normals = normals_ / weight_;
    summary.covariance = squares_ / weight_ - summary.normals * summary.normals.transpose();
    for (const OfEffect& of : effects_) {
      EffectSummary one{
          of.weight / weight_, {}, {}, {}, {}, of.weight > 0.0 ? VectorXd(of.curve / of.weight) : of.curve};
      const auto dimensions = static_cast<Index>(of.parameters.size());
      for (VectorXd* numbers : {&one.place, &one.deviation, &one.lower, &one.upper})
        *numbers = VectorXd::Constant(dimensions, std::numeric_limits<double>::quiet_NaN());
      for (Index d = 0; d < dimensions && of.weight > 0.0; ++d) {
        const Mixture& mixture = of.parameters[static_cast<std::size_t>(d)];
        double mean = 0.0, square = 0.0;
        for (std::size_t i = 0; i < mixture.weight.size(); ++i) {
          const double share = mixture.weight[i] / of.weight;
          mean += share * mixture.mean[i];
          square += share * (mixture.mean[i] * mixture.mean[i] + mixture.deviation[i] * mixture.deviation[i]);
        }
        one.place(d) = std::clamp(mean, 0.0, 1.0);
        one.deviation(d) = std::sqrt(std::max(square - mean * mean, 0.0));
        one.lower(d) = mixture.quantile(0.05);
        one.upper(d) = mixture.quantile(0.95);
      }
      summary.each.push_back(std::move(one));
    }
    return summary;
  }

 private:
  struct Sums {
    VectorXd first, second;
    void add(const VectorXd& mean, const VectorXd& variance, double weight) {
      first += weight * mean;
      second += weight * (mean.cwiseAbs2() + variance);
    }
  };
  struct OfEffect {
    double weight = 0.0;
    VectorXd curve;
    std::vector<Mixture> parameters;
  };

  // The columns' normals given the residual: mean A^-1 v, covariance A^-1, A = 1 + U' C^-1 U.
  void add(const Subset& subset, const Place& place, double weight) {
    const Metric& metric = weigher_.metrics()[place.metric];
    const Index n = residual_.size();
    Index columns = 0;
    for (std::size_t k = 0; k < subset.effects.size(); ++k) columns += spread(subset, place, k).cols();
    MatrixXd U(n, columns);
    VectorXd rest = residual_, curves = VectorXd::Zero(n);
    for (Index k = 0, at = 0; k < static_cast<Index>(subset.effects.size()); ++k) {
      const MatrixXd& own = spread(subset, place, static_cast<std::size_t>(k));
      U.middleCols(at, own.cols()) = own;
      at += own.cols();
      curves += weigher_.fine()[subset.effects[static_cast<std::size_t>(k)]].curves.col(
          place.combination.node[static_cast<std::size_t>(k)]);
    }
    rest -= curves;
    const MatrixXd whitened = metric.whitening * U;
    const MatrixXd A = MatrixXd::Identity(columns, columns) + whitened.transpose() * whitened;
    const MatrixXd covariance = A.inverse();
    const VectorXd normals = covariance * (whitened.transpose() * (metric.whitening * rest));
    const VectorXd effects = curves + U * normals;
    VectorXd variance = (U * covariance).cwiseProduct(U).rowwise().sum();
    rest -= U * normals;
    const VectorXd pull = metric.whitening.transpose() * (metric.whitening * rest);  // C^-1 e
    VectorXd other = VectorXd::Zero(n), other_variance = VectorXd::Zero(n);
    if (metric.something_else()) {
      const MatrixXd& plain = covariance_without(metric.noise);
      other = rest - plain * pull;
      const MatrixXd half = metric.whitening * plain;
      other_variance = plain.diagonal() - half.colwise().squaredNorm().transpose();
    }
    all_.add(effects + other, variance + other_variance.cwiseMax(0.0), weight);
    else_.add(other, other_variance.cwiseMax(0.0), weight);
    soil_ += weight * (parameters_ * (parameters_.transpose() * pull));
    add_normals(place.metric, whitened, covariance, pull, weight);
    weight_ += weight;
    for (Index k = 0, at = 0; k < static_cast<Index>(subset.effects.size()); ++k) {
      const auto entry = static_cast<std::size_t>(k);
      const std::size_t effect = subset.effects[entry];
      const EffectNodes& nodes = weigher_.fine()[effect];
      OfEffect& of = effects_[effect];
      const Index node = place.combination.node[entry], own = spread(subset, place, entry).cols();
      of.weight += weight;
      of.curve += weight * (nodes.curves.col(node) + U.middleCols(at, own) * normals.segment(at, own));
      for (Index d = 0; d < nodes.steps.size(); ++d) {
        Mixture& mixture = of.parameters[static_cast<std::size_t>(d)];
        mixture.weight.push_back(weight);
        mixture.mean.push_back(nodes.places(node, d) + nodes.steps(d) * normals(at + d));
        mixture.deviation.push_back(nodes.steps(d) * std::sqrt(covariance(at + d, at + d)));
      }
      at += own;
    }
  }

  // The soil's given the columns are F'C^-1 (e - U normals), 1 - F'C^-1 F; the columns' own add to it.
  void add_normals(std::size_t metric, const MatrixXd& whitened, const MatrixXd& covariance,
                   const VectorXd& pull, double weight) {
    if (normals_.size() == 0) return;
    const auto [entry, fresh] = soil_whitened_.try_emplace(metric);
    const auto F = parameters_.leftCols(normals_.size());
    if (fresh) entry->second = weigher_.metrics()[metric].whitening * F;
    const MatrixXd& own = entry->second;
    const VectorXd mean = F.transpose() * pull;
    const MatrixXd cross = own.transpose() * whitened;
    normals_ += weight * mean;
    squares_ += weight * (mean * mean.transpose() + MatrixXd::Identity(own.cols(), own.cols()) -
                          own.transpose() * own + cross * covariance * cross.transpose());
  }

  [[nodiscard]] const MatrixXd& spread(const Subset& subset, const Place& place, std::size_t k) const {
    return weigher_.fine()[subset.effects[k]].spreads[static_cast<std::size_t>(place.combination.node[k])];
  }

  // Of the metric with the same noise and nothing else.
  const MatrixXd& covariance_without(std::size_t noise) {
    const auto [entry, fresh] = plain_.try_emplace(noise);
    if (fresh)
      for (const Metric& metric : weigher_.metrics())
        if (!metric.something_else() && metric.noise == noise) entry->second = metric.covariance();
    return entry->second;
  }

  const SubsetWeigher& weigher_;
  const VectorXd& residual_;
  const MatrixXd& parameters_;
  VectorXd normals_;
  MatrixXd squares_;
  std::map<std::size_t, MatrixXd> soil_whitened_;  // of each metric
  double weight_ = 0.0;
  Sums all_, else_;
  VectorXd soil_;
  std::vector<OfEffect> effects_;
  std::map<std::size_t, MatrixXd> plain_;
};

}  // namespace

Summary summarize(const SubsetWeigher& weigher, const Explained& explained, const VectorXd& residual,
                  const MatrixXd& parameters, Index soil) {
  Summarizer summarizer(weigher, residual, parameters, soil);
  for (const WeighedSubset& weighed : explained.subsets) summarizer.add(weighed, weighed.probability);
  return summarizer.done();
}

Summary summarize(const SubsetWeigher& weigher, const WeighedSubset& subset, const VectorXd& residual,
                  const MatrixXd& parameters, Index soil) {
  Summarizer summarizer(weigher, residual, parameters, soil);
  summarizer.add(subset, 1.0);
  return summarizer.done();
}

TwoSidedCheck check_subset(const SubsetWeigher& weigher, const WeighedSubset& subset,
                           const VectorXd& residual) {
  TwoSidedCheck check{0.0, static_cast<double>(residual.size()), 0.0};
  double held = 0.0;
  std::map<std::size_t, Combinations> in;  // of each metric
  for (const Place& place : subset.places) {
    auto entry = in.find(place.metric);
    if (entry == in.end())
      entry = in.emplace(place.metric, weigher.at(place.metric, subset.subset.effects)).first;
    check.chi_square += place.probability * entry->second.distance(entry->second.target(residual),
                                                                   subset.subset.effects, place.combination);
    held += place.probability;
  }
  check.chi_square /= held;
  const double below = boost::math::cdf(boost::math::chi_squared(check.freedom), check.chi_square);
  check.p = 2.0 * std::min(below, 1.0 - below);
  return check;
}

}  // namespace cpt::diagnosis

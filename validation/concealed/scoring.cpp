#include "validation/concealed/scoring.hpp"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace cpt::validation::concealed {
namespace {

std::vector<int> by_probability(const diagnosis::VectorXd& probabilities) {
  std::vector<int> order(static_cast<std::size_t>(probabilities.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return probabilities(a) > probabilities(b); });
  return order;
}

template <class Predicate>
Proportion share(const std::vector<ScoredCase>& cases, Predicate right) {
  return proportion(static_cast<int>(std::count_if(cases.begin(), cases.end(), right)),
                    static_cast<int>(cases.size()));
}

// Sorted and without overlaps.
Intervals united(Intervals intervals) {
  std::sort(intervals.begin(), intervals.end());
  Intervals result;
  for (const auto& [from, to] : intervals) {
    if (!(to > from)) continue;
    if (!result.empty() && from <= result.back().second)
      result.back().second = std::max(result.back().second, to);
    else
      result.emplace_back(from, to);
  }
  return result;
}

double measure(const Intervals& intervals) {
  double sum = 0.0;
  for (const auto& [from, to] : intervals) sum += to - from;
  return sum;
}

}  // namespace

Proportion proportion(int count, int of, double confidence) {
  if (count < 0 || count > of || !(confidence > 0.0 && confidence < 1.0))
    throw std::invalid_argument("no proportion");
  const double tail = 0.5 * (1.0 - confidence);
  Proportion p{count, of, of > 0 ? static_cast<double>(count) / of : std::numeric_limits<double>::quiet_NaN(),
               0.0, 1.0};
  if (count > 0) p.lower = quantile(boost::math::beta_distribution<>(count, of - count + 1.0), tail);
  if (count < of) p.upper = quantile(boost::math::beta_distribution<>(count + 1.0, of - count), 1.0 - tail);
  return p;
}

Eigen::MatrixXi confusion_matrix(const std::vector<ScoredCase>& cases, int labels) {
  Eigen::MatrixXi matrix = Eigen::MatrixXi::Zero(labels, labels);
  for (const ScoredCase& c : cases) ++matrix(c.truth, c.answer);
  return matrix;
}

Proportion accuracy(const std::vector<ScoredCase>& cases) {
  return share(cases, [](const ScoredCase& c) { return c.answer == c.truth; });
}

Proportion top(const std::vector<ScoredCase>& cases, int k) {
  return share(cases, [k](const ScoredCase& c) {
    const std::vector<int> order = by_probability(c.probabilities);
    const auto end = order.begin() + std::min<std::ptrdiff_t>(k, std::ssize(order));
    return std::find(order.begin(), end, c.truth) != end;
  });
}

double brier_score(const std::vector<ScoredCase>& cases) {
  double sum = 0.0;
  for (const ScoredCase& c : cases) {
    diagnosis::VectorXd apart = c.probabilities;
    apart(c.truth) -= 1.0;
    sum += apart.squaredNorm();
  }
  return sum / static_cast<double>(cases.size());
}

double log_score(const std::vector<ScoredCase>& cases) {
  double sum = 0.0;
  for (const ScoredCase& c : cases) sum += std::log(std::max(c.probabilities(c.truth), 1e-12));
  return sum / static_cast<double>(cases.size());
}

SetScore set_score(const std::vector<ScoredCase>& cases) {
  double size = 0.0;
  for (const ScoredCase& c : cases) size += static_cast<double>(c.set.size());
  const auto covered = [](const ScoredCase& c) {
    return std::find(c.set.begin(), c.set.end(), c.truth) != c.set.end();
  };
  return {share(cases, covered), size / static_cast<double>(cases.size())};
}

Retrieval retrieval(const std::vector<ScoredCase>& cases, int label) {
  int answered = 0, true_cases = 0, both = 0;
  for (const ScoredCase& c : cases) {
    answered += c.answer == label ? 1 : 0;
    true_cases += c.truth == label ? 1 : 0;
    both += c.answer == label && c.truth == label ? 1 : 0;
  }
  return {proportion(both, answered), proportion(both, true_cases)};
}

double overlap(const Intervals& a, const Intervals& b) {
  Intervals both = a;
  both.insert(both.end(), b.begin(), b.end());
  const double either = measure(united(both));
  if (either == 0.0) return 1.0;
  return (measure(united(a)) + measure(united(b)) - either) / either;
}

std::vector<ReliabilityBin> reliability(const std::vector<ScoredCase>& cases, int bins) {
  std::vector<ReliabilityBin> result;
  for (int b = 0; b < bins; ++b) {
    const double from = static_cast<double>(b) / bins, to = static_cast<double>(b + 1) / bins;
    int count = 0, right = 0;
    double claimed = 0.0;
    for (const ScoredCase& c : cases) {
      const double p = c.probabilities(c.answer);
      if (p < from || (p >= to && b + 1 < bins)) continue;
      ++count;
      right += c.answer == c.truth ? 1 : 0;
      claimed += p;
    }
    result.push_back({from, to, claimed / count, proportion(right, count)});  // 0 / 0 = NaN
  }
  return result;
}

}  // namespace cpt::validation::concealed
